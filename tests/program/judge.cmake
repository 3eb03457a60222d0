# SPDX-License-Identifier: BSL-1.0
# cmake -D hilger=<program> -D judge=<program> -D scene=<name> -D epsilon=<number> -D options=<list> -D out=<directory> -P judge.cmake
# What a scene writes, a row for each step, solves the equation that its method was derived from.
file(REMOVE_RECURSE ${out})
execute_process(COMMAND ${hilger} run ${scene} ${options} --every 1 --out ${out} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "hilger run ${scene} failed: ${said}")
endif()
execute_process(COMMAND ${judge} ${scene} ${out}/${scene}.csv ${epsilon} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
message("${said}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the rows of ${scene} do not solve its equation")
endif()
