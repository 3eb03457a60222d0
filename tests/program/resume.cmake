# SPDX-License-Identifier: BSL-1.0
# cmake -D hilger=<program> -D scene=<name> -D options=<list> -D out=<directory> -P resume.cmake
# A run that is stopped again and again, and continued, writes byte for byte what one that is not writes.
cmake_minimum_required(VERSION 3.22)
cmake_path(GET scene STEM name) # of a file
file(REMOVE_RECURSE ${out})
execute_process(COMMAND ${hilger} run ${scene} ${options} --out ${out}/whole RESULT_VARIABLE result OUTPUT_VARIABLE said)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "hilger run ${scene} failed: ${said}")
endif()
set(stopped 0)
foreach(attempt RANGE 1 400)
  # 130 says that there is more to come.
  execute_process(COMMAND ${hilger} run ${scene} ${options} --stop-after ${stop} --out ${out}/parts RESULT_VARIABLE result
    OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(result EQUAL 0)
    break()
  elseif(NOT result EQUAL 130)
    message(FATAL_ERROR "hilger run ${scene} ended with ${result}: ${said}")
  endif()
  math(EXPR stopped "${stopped} + 1")
endforeach()
if(stopped LESS 3)
  message(FATAL_ERROR "the run of ${scene} was interrupted ${stopped} times only, and nothing is seen from that")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${out}/whole/${name}.csv ${out}/parts/${name}.csv RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "a run of ${scene} that was interrupted ${stopped} times has other rows than one that was not")
endif()
if(EXISTS ${out}/parts/${name}.checkpoint)
  message(FATAL_ERROR "a run that has ended leaves no checkpoint")
endif()
# What was interrupted does not go on where the file says something else by now.
if(EXISTS ${scene})
  file(READ ${scene} text)
  file(WRITE ${out}/changed/${name}.toml "${text}")
  execute_process(COMMAND ${hilger} run ${name}.toml ${options} --stop-after 5 --out ${out}/changed WORKING_DIRECTORY ${out}/changed
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  file(APPEND ${out}/changed/${name}.toml "\n# changed\n")
  execute_process(COMMAND ${hilger} run ${name}.toml ${options} --out ${out}/changed WORKING_DIRECTORY ${out}/changed
    RESULT_VARIABLE continued OUTPUT_QUIET ERROR_VARIABLE said)
  if(NOT result EQUAL 130 OR NOT continued EQUAL 1 OR NOT said MATCHES "of what the file said before; give --anew or another --out")
    message(FATAL_ERROR "a run of a changed file went on (${result}, ${continued}): ${said}")
  endif()
endif()
