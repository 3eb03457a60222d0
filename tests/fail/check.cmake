# SPDX-License-Identifier: BSL-1.0
# Compiles one case: cmake -D source= -D must= -D compiler= -D compiler_id= -D includes= -D system= -P check.cmake
# must=compile      the twin, compiled as it is, compiles
# must=not_compile  with MUST_NOT_COMPILE defined it does not; on g++ the message contains the text of each "// expect: <text>" line
#                   and is at most 20 lines long, not counting those that say who included whom. (clang 14 writes a text that is a
#                   template argument as a list of numbers, so there the refusal is all that is checked.)
cmake_minimum_required(VERSION 3.22)
set(longest 20)

set(command ${compiler} -std=c++20 -fsyntax-only ${source})
foreach(directory IN LISTS includes)
  list(APPEND command -I${directory})
endforeach()
foreach(directory IN LISTS system)
  list(APPEND command -isystem ${directory})
endforeach()
if(must STREQUAL "not_compile")
  list(APPEND command -DMUST_NOT_COMPILE)
endif()

set(ENV{LC_ALL} C) # plain quotation marks in messages
execute_process(COMMAND ${command} RESULT_VARIABLE result OUTPUT_VARIABLE message ERROR_VARIABLE message)

if(must STREQUAL "compile")
  if(NOT result EQUAL 0)
    message(NOTICE "${message}")
    message(FATAL_ERROR "The twin does not compile.")
  endif()
  return()
endif()

if(result EQUAL 0)
  message(FATAL_ERROR "It compiles, and must not.")
endif()
if(NOT compiler_id STREQUAL "GNU")
  return()
endif()

file(READ ${source} rest)
set(expected 0)
while(rest MATCHES "// expect: ([^\n]+)(.*)")
  set(text "${CMAKE_MATCH_1}")
  set(rest "${CMAKE_MATCH_2}")
  math(EXPR expected "${expected} + 1")
  string(FIND "${message}" "${text}" position)
  if(position EQUAL -1)
    message(NOTICE "${message}")
    message(FATAL_ERROR "The message does not contain \"${text}\".")
  endif()
endwhile()
if(expected EQUAL 0)
  message(FATAL_ERROR "The case does not say what it expects: add a line \"// expect: <text of the message>\".")
endif()

string(REGEX REPLACE "(In file included from| +from )[^\n]*\n" "" counted "${message}")
string(REGEX MATCHALL "\n" lines "${counted}")
list(LENGTH lines lines)
if(lines GREATER longest)
  message(NOTICE "${message}")
  message(FATAL_ERROR "The message has ${lines} lines, more than ${longest}.")
endif()
