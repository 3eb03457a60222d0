# SPDX-License-Identifier: BSL-1.0
# cmake -D hilger=<program> -D out=<directory> -P wrong_files.cmake
# What is wrong in a file is said with line and column, in one sentence, and nothing is written.
set(right [[
lagrangian = "v^2/2 - q^2/2"
interval = [0, 1]
steps = 10
initial = { q = 1, v = 0 }
]])
set(failed "")
# says(<what is replaced> <by> <sentence>): the one file that is right, changed in one place
function(says old new sentence)
  string(REPLACE "${old}" "${new}" text "${right}")
  if(text STREQUAL right)
    message(FATAL_ERROR "'${old}' is not in the file")
  endif()
  file(WRITE ${out}/wrong.toml "${text}")
  execute_process(COMMAND ${hilger} run wrong.toml --out rows WORKING_DIRECTORY ${out} RESULT_VARIABLE result OUTPUT_VARIABLE said
    ERROR_VARIABLE said TIMEOUT 20)
  if(NOT result EQUAL 1 OR NOT said STREQUAL "hilger: wrong.toml${sentence}\n")
    message(SEND_ERROR "expected: hilger: wrong.toml${sentence}\nsaid (${result}): ${said}")
  endif()
  if(EXISTS ${out}/rows)
    message(SEND_ERROR "something was written")
  endif()
endfunction()
file(REMOVE_RECURSE ${out})
says("q^2/2" "k*q^2" ", line 1, column 23: 'k' has no meaning: there are q, t, v")
says("q^2/2" "(q" ", line 1, column 25: ')' was expected, and there is the end")
says("q^2/2" "cos(q, v)" ", line 1, column 23: cos takes 1 argument, and here are 2")
says("lagrangian =" "lagrange =" ", line 1, column 1: there is no key 'lagrange': there are title, lagrangian, force, parameters, coordinates, velocities, interval, steps, initial, embedding, damping, history")
says("steps = 10\n" "" ": there is no steps, which a problem has")
says("steps = 10" "steps = 1.5" ", line 3, column 9: steps is a positive whole number")
says("steps = 10" "steps = -3" ", line 3, column 9: steps is a positive whole number")
says("[0, 1]" "[1, 0]" ", line 2, column 12: an interval is two numbers, the smaller one first")
says("[0, 1]" "[0, \"one\"]" ", line 2, column 16: a number was expected, as 1, 0.5 or \"1/3\"")
says("{ q = 1, v = 0 }" "{ q = 1 }" ", line 4, column 11: the initial values have no 'v'")
says("{ q = 1, v = 0 }" "{ q = [1, 2], v = 0 }" ", line 4, column 17: 'q' has 1 initial values, and here are 2")
says("{ q = 1, v = 0 }" "{ q = 1, v = 0, w = 1 }" ", line 4, column 11: there are initial values of what is no coordinate and no velocity")
says("steps = 10" "steps = 10\nembedding = \"euler\"" ", line 4, column 13: the embedding is one of order-one, mid-point, verlet, gauss-4, gauss-8 here, and not 'euler'")
says("steps = 10" "steps = 10\ndamping = [ { rho = 1, alpha = 3 } ]" ", line 4, column 32: alpha lies between 0 and 2")
says("steps = 10" "steps = 10\nhistory = \"blocks\"" ", line 4, column 11: a history is for fractional damping, and there is none")
says("steps = 10" "steps = 10\nforce = [\"v\", \"v\"]" ", line 4, column 9: a force has one formula for each coordinate, and here are 2 for 1")
says("steps = 10" "steps = 10\nparameters = { q = 1 }" ", line 4, column 20: each name has one meaning, and 'q' was given two")
says("steps = 10" "steps = 10\ncoordinates = \"q[x]\"" ", line 4, column 15: a coordinate is written as \"q\" or \"q[3]\", and here is \"q[x]\"")
