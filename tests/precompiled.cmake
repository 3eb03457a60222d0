# SPDX-License-Identifier: BSL-1.0
# One main and one precompiled header for all doctest programs.
find_package(doctest REQUIRED)
find_package(rapidcheck REQUIRED)
add_library(test_main OBJECT tests/main.cpp)
target_link_libraries(test_main PUBLIC hilger_development doctest::doctest rapidcheck)
target_include_directories(test_main PUBLIC ${PROJECT_SOURCE_DIR}/tests) # support/
target_precompile_headers(test_main PRIVATE tests/precompiled.hpp)

# What most files instantiate alike, clang instantiates in the precompiled header and compiles once, for the program too. g++ would compile
# it in each of them.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang" AND CMAKE_BUILD_TYPE STREQUAL "Debug" AND CMAKE_GENERATOR STREQUAL "Ninja")
  target_precompile_headers(test_main PRIVATE tests/shared_code.hpp)
  target_compile_options(test_main PRIVATE -fpch-codegen)
  set(shared_header ${PROJECT_BINARY_DIR}/CMakeFiles/test_main.dir/cmake_pch.hxx.pch)
  set(shared_object ${PROJECT_BINARY_DIR}/shared_code.o)
  separate_arguments(shared_flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_DEBUG}")
  # Optimised: a minute of work for one object, by which all tests together run in two thirds of the time.
  add_custom_command(OUTPUT ${shared_object} DEPENDS ${shared_header} COMMENT "Compiling what the tests share"
    COMMAND ${CMAKE_CXX_COMPILER} ${shared_flags} -O1 -c ${shared_header} -o ${shared_object})
  add_custom_target(shared_code DEPENDS ${shared_object})
  set_target_properties(shared_code PROPERTIES OBJECT_FILE ${shared_object})
  # That refers to doctest, which programs without test_main take from here.
  add_library(doctest_itself STATIC tests/doctest.cpp)
  target_link_libraries(doctest_itself PRIVATE doctest::doctest)
endif()
