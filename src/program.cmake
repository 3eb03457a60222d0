# SPDX-License-Identifier: BSL-1.0
# The command-line program.
file(GLOB sources CONFIGURE_DEPENDS *.cpp scenes/*.cpp problems/*.cpp)
list(FILTER sources EXCLUDE REGEX "/(demo|solar_system|numbers|engines.*)[.]cpp$")
# Scales of one step take no time, nor do proofs in rationals and what papers print; many digits have theirs in loops that are
# compiled elsewhere; and optimising all that takes minutes. In a library of their own they share what is precompiled for the extremes; of
# what is in several files the linker takes the first, which is the program's own.
set(not_optimised main.cpp papers_bourdin.cpp papers_cresson.cpp papers_galucio.cpp papers_jimenez.cpp prove.cpp problems/from_file.cpp
  problems/newmark_in_50_digits.cpp problems/observed_in_file.cpp problems/stated.cpp)
list(TRANSFORM not_optimised PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
add_executable(hilger)
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  list(REMOVE_ITEM sources ${not_optimised})
  add_library(hilger_not_optimised STATIC ${not_optimised})
  target_compile_options(hilger_not_optimised PRIVATE -Og)
  target_compile_definitions(hilger_not_optimised PRIVATE HILGER_DEBUG)
  target_precompile_headers(hilger_not_optimised REUSE_FROM extremes)
  target_include_directories(hilger_not_optimised SYSTEM PRIVATE ${HILGER_TOMLPLUSPLUS})
  target_include_directories(hilger_not_optimised PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR})
  target_link_libraries(hilger_not_optimised PRIVATE hilger_development hilger_engine)
  target_link_libraries(hilger PRIVATE hilger_not_optimised)
  # Runs take the same time with -O3, and what is compiled here a sixth more.
  target_compile_options(hilger PRIVATE -O2)
  target_precompile_headers(hilger PRIVATE compiled_once.hpp)
  link_numbers(hilger)
  set(precompiled_for_programs hilger PARENT_SCOPE)
else()
  if(HILGER_TEST_EVERYTHING)
    set_source_files_properties(${not_optimised} PROPERTIES SKIP_PRECOMPILE_HEADERS ON) # they include what they use
  endif()
  precompile_as(hilger ${precompiled})
endif()
target_sources(hilger PRIVATE ${sources})
set_target_properties(hilger PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
target_include_directories(hilger PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR})
target_include_directories(hilger SYSTEM PRIVATE ${HILGER_TOMLPLUSPLUS})
target_link_libraries(hilger PRIVATE hilger_development extremes hilger_engine CLI11::CLI11)
# One more peer for hilger trade, where it is installed (libgsl-dev).
find_package(GSL QUIET)
if(GSL_FOUND)
  target_link_libraries(hilger PRIVATE GSL::gsl)
endif()
set_property(SOURCE scenes/peers.cpp PROPERTY COMPILE_DEFINITIONS PROGRAM_HAS_GSL=$<BOOL:${GSL_FOUND}>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ does not see that what Boost.odeint copies is not read before it is written.
  set_source_files_properties(scenes/peers.cpp PROPERTIES COMPILE_OPTIONS "-Wno-maybe-uninitialized;-Wno-uninitialized")
endif()
set_property(SOURCE scenes/peers.cpp APPEND PROPERTY COMPILE_OPTIONS ${less_memory})
# Scenes in files travel inside the program, under their names with - for _.
file(GLOB problems CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/problems/*.toml)
set(texts)
foreach(problem IN LISTS problems)
  cmake_path(GET problem STEM name)
  string(REPLACE _ - name ${name})
  file(READ ${problem} text)
  string(APPEND texts "    {\"${name}\", R\"toml(${text})toml\"},\n")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${problem})
endforeach()
file(CONFIGURE OUTPUT problems_in_files.hpp CONTENT
  "#include <utility>\ninline constexpr std::pair<char const*, char const*> problems_in_files[]{\n@texts@};\n" @ONLY)
install(TARGETS hilger COMPONENT program)
