# SPDX-License-Identifier: BSL-1.0
# Arrows point down only: cmake -D include=<the folder include> -P include_direction.cmake
# A header includes from its own folder or from folders written before it here; the folders of one line do not know each other.
cmake_minimum_required(VERSION 3.22)

set(order
  "inlining.hpp"
  "error.hpp error_free.hpp fixed_text.hpp function_view.hpp scalar.hpp version.hpp"
  "shape.hpp simd.hpp whole_number.hpp"
  "scale"
  "function"
  "operator"
  "adjoint"
  "printing"
  "fourier"
  "history"
  "embedding"
  "linear"
  "differentiation"
  "newton"
  "models"
  "variational"
  "step"
  "trajectory"
  "integrator"
  "composition accuracy"
  "fractional"
  "boundary"
  "multiprecision.hpp" # text alone computes with numbers of its own: it compares operators exactly
  "text"
  "scene")
# These, and what they include, take the scalar and the vector as template parameters.
set(lean error.hpp error_free.hpp fixed_text.hpp function_view.hpp inlining.hpp scalar.hpp version.hpp whole_number.hpp scale function operator adjoint printing)

set(rank 0)
foreach(line IN LISTS order)
  math(EXPR rank "${rank} + 1")
  string(REPLACE " " ";" line "${line}")
  foreach(folder IN LISTS line)
    set(rank_${folder} ${rank})
  endforeach()
endforeach()

set(errors "")
file(GLOB_RECURSE headers RELATIVE ${include} ${include}/hilger/*.hpp)
if(NOT headers)
  message(FATAL_ERROR "There are no headers in ${include}/hilger.")
endif()
foreach(header IN LISTS headers)
  string(REGEX REPLACE "^hilger/([^/]+).*" "\\1" folder ${header})
  if(NOT DEFINED rank_${folder})
    if(header MATCHES "/.*/")
      string(APPEND errors "${header}: the folder ${folder} has no place in the order of ${CMAKE_CURRENT_LIST_FILE}\n")
    endif()
    continue() # hilger.hpp, the table of contents, and headers only users include
  endif()

  file(STRINGS ${include}/${header} lines REGEX "^ *# *include")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]+)[>\"].*" "\\1" included "${line}")
    string(REGEX REPLACE "^hilger/([^/]+).*" "\\1" target "${included}")
    if(included MATCHES "^hilger/")
      if(NOT DEFINED rank_${target})
        string(APPEND errors "${header} includes ${included}, which is for users\n")
      elseif(NOT target STREQUAL folder AND NOT rank_${target} LESS rank_${folder})
        string(APPEND errors "${header} includes ${included}, but ${target} is not below ${folder}\n")
      endif()
    elseif(line MATCHES "\"")
      string(APPEND errors "${header} includes ${included}: write the path from hilger/ on\n")
    elseif(folder IN_LIST lean AND included MATCHES "^(Eigen|unsupported|boost)/")
      string(APPEND errors "${header} includes ${included}, but ${folder} knows neither Eigen nor Boost\n")
    endif()
  endforeach()
endforeach()

if(errors)
  message(NOTICE "${errors}")
  message(FATAL_ERROR "Includes must point down.")
endif()
