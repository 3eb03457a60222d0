# SPDX-License-Identifier: BSL-1.0
# The command-line program.
file(GLOB sources CONFIGURE_DEPENDS *.cpp scenes/*.cpp problems/*.cpp engine/machine_code/*.cpp engine/ensemble/*.cpp
  engine/methods/two_sided.cpp engine/methods/lambda.cpp)
# Counting takes no time, nor do scales of one step, proofs in rationals and what papers print; many digits have theirs in loops that are
# compiled elsewhere; and optimising all that takes minutes. Last: of what is in several files the linker takes the first.
set(not_optimised papers_bourdin.cpp papers_cresson.cpp papers_jimenez.cpp scenes/cost.cpp
  scenes/cost_with_force.cpp scenes/cost_with_memory.cpp problems/boundary_walk.cpp problems/from_file.cpp problems/observed_in_file.cpp
  engine/methods/lambda.cpp)
list(TRANSFORM not_optimised PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
list(FILTER sources EXCLUDE REGEX "/(demo|solar_system|numbers|engines.*)[.]cpp$")
list(REMOVE_ITEM sources ${not_optimised})
add_executable(hilger ${sources} ${not_optimised})
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  set_source_files_properties(${not_optimised} extremes/smallest.cpp
    PROPERTIES COMPILE_OPTIONS -Og COMPILE_DEFINITIONS HILGER_DEBUG SKIP_PRECOMPILE_HEADERS ON)
elseif(HILGER_TEST_EVERYTHING)
  set_source_files_properties(${not_optimised} PROPERTIES SKIP_PRECOMPILE_HEADERS ON) # they include what they use
endif()
precompile_as(hilger extremes)
set_target_properties(hilger PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
target_include_directories(hilger PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR})
target_include_directories(hilger SYSTEM PRIVATE ${HILGER_TOMLPLUSPLUS})
target_link_libraries(hilger PRIVATE hilger_development extremes CLI11::CLI11 ${CMAKE_DL_LIBS})
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
# What problems in files have in states of each small size, and in each number of digits, is a file of its own, for it takes its time. Of
# many digits the time goes into loops over them.
function(add_stated group name of text)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/stated/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT ${text})
  if(CMAKE_BUILD_TYPE STREQUAL "Release" AND of MATCHES "hilger")
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -Og SKIP_PRECOMPILE_HEADERS ON)
  endif()
  # Where nothing is optimised, what they have in common takes longer than what they have not.
  set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  target_sources(hilger PRIVATE ${source})
endfunction()
foreach(number IN ITEMS double float)
  foreach(dimension IN ITEMS 1 2 3)
    foreach(kind IN ITEMS without_inner_points with_inner_points)
      add_stated(small small_${dimension}_${kind}_in_${number} ${number}
        "#include \"problems/stated_small.hpp\"\nPROGRAM_SMALL(${number}, ${dimension}, ${kind})\n")
    endforeach()
  endforeach()
endforeach()
foreach(number IN ITEMS double float hilger::float50 hilger::float100)
  string(REPLACE hilger:: "" name ${number})
  set(engines)
  if(name STREQUAL "float")
    set(engines "PROGRAM_ENGINES_IN_FLOAT()\n")
  endif()
  add_stated(in_numbers in_${name} ${number}
    "#include \"problems/in_numbers.hpp\"\n${engines}PROGRAM_IN_NUMBERS(${number})\n")
endforeach()
foreach(number IN ITEMS double hilger::float50)
  string(REPLACE hilger:: "" name ${number})
  add_stated(memory memory_in_${name} ${number} "#include \"problems/memory_walk.hpp\"\nPROGRAM_WITH_MEMORY(${number})\n")
endforeach()
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
# Scenes have their methods in common.
set_target_properties(hilger PROPERTIES UNITY_BUILD ${HILGER_UNITY_TESTS} UNITY_BUILD_MODE GROUP)
install(TARGETS hilger COMPONENT program)
