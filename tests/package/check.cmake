# SPDX-License-Identifier: BSL-1.0
# Configures, builds and runs the consumer; the variables it needs are given in tests/checks/CMakeLists.txt.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(NOTICE "${command}\n${output}")
    message(FATAL_ERROR "A project that uses hilger by ${way} does not work.")
  endif()
endfunction()

file(REMOVE_RECURSE ${binary})
if(way STREQUAL "find_package")
  run(${CMAKE_COMMAND} --install ${hilger_binary} --prefix ${binary}/prefix --component development)
endif()
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${binary}/build -G ${generator}
  -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${binary}/prefix -D way=${way} -D hilger_source=${hilger_source}
  -D hilger_version=${hilger_version} -D "CMAKE_EXE_LINKER_FLAGS=${flags}") # what hilger_text was compiled with may need a runtime
run(${CMAKE_COMMAND} --build ${binary}/build)
run(${binary}/build/consumer)
if(way STREQUAL "find_package" AND text)
  run(${binary}/build/reader)
endif()
