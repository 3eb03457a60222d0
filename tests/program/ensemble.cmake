# SPDX-License-Identifier: BSL-1.0
# cmake -D hilger=<program> -D out=<directory> -P ensemble.cmake
# A problem from each row of a table: one file, the same to the last byte from one process or from three, each of which knows its number;
# a member with the file's own data is the run of the file, in which one alone is a table of one row; who fails is told.
file(REMOVE_RECURSE ${out})
file(WRITE ${out}/pendulum.toml [[
lagrangian = "m*v^2/2 - m*g*(1 - cos(q)) + k[0]*q^4 - k[1]*q^2"
parameters = { m = 1, g = 9.81, k = [0, "1/4"] }
interval = [0, 4]
steps = 100
embedding = "mid-point"
initial = { q = 2, v = "1/3" }
]])
file(WRITE ${out}/members.csv "# q, g, k[0]\n1,9.81,0\n2, 9.81, 0\n\n0.5,1/2,0\n1.5,1.6,1e-2\n40,9.81,1000\n-1,3,0\n0.25,9,0.125\n")
function(run result_is folder members)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env ${ARGN} ${hilger} run pendulum.toml --ensemble ${members} --out ${folder} --every 30
    WORKING_DIRECTORY ${out} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE complained)
  if(NOT result EQUAL ${result_is})
    message(FATAL_ERROR "expected ${result_is}: ${result}: ${said}${complained}")
  endif()
  set(said "${said}${complained}" PARENT_SCOPE)
endfunction()
function(expect text)
  string(FIND "${said}" "${text}" at)
  if(at EQUAL -1)
    message(SEND_ERROR "expected '${text}' in: ${said}")
  endif()
endfunction()

run(0 one members.csv)
expect("members 0 to 6 of 7, mid-point")
expect("1 failed\n  member 4: the step from t = ")
expect("one/pendulum.npy, q and p of 7 members at 5 points, every 30")
file(SIZE ${out}/one/pendulum.npy size)
math(EXPR expected "128 + 7 * 5 * 2 * 8")
if(NOT size EQUAL expected)
  message(SEND_ERROR "the file has ${size} bytes, and not ${expected}")
endif()
# Spreadsheets begin UTF-8 with a mark.
string(ASCII 239 187 191 mark)
file(READ ${out}/members.csv members)
string(REPLACE "# q" "${mark}q" members "${members}")
file(WRITE ${out}/marked.csv "${members}")
run(0 marked marked.csv)
file(SHA256 ${out}/one/pendulum.npy one)
file(SHA256 ${out}/marked/pendulum.npy marked)
if(NOT one STREQUAL marked)
  message(SEND_ERROR "a mark of UTF-8 changed the members")
endif()
# What is interrupted leaves the file of who came to the end, and keeps its own beside it; one of which nobody comes to the end has failed.
string(REPEAT "1,9.81,0\n" 4000 rows)
file(WRITE ${out}/for_minutes.csv "q,g,k[0]\n${rows}")
execute_process(COMMAND sh -c "\"$0\" run pendulum.toml --ensemble for_minutes.csv --out one --steps 10000000 &
  while [ ! -e one/pendulum.interrupted.npy ]; do kill -0 $! || exit; sleep 0.1; done; kill -INT $!; wait $!" ${hilger}
  WORKING_DIRECTORY ${out} RESULT_VARIABLE result OUTPUT_VARIABLE said)
file(SHA256 ${out}/one/pendulum.npy again)
if(NOT result EQUAL 130 OR NOT one STREQUAL again OR NOT EXISTS ${out}/one/pendulum.interrupted.npy)
  message(SEND_ERROR "an interrupted ensemble (${result}) took the place of a whole one: ${said}")
endif()
expect("Written: one/pendulum.interrupted.npy")
run(0 marked members.csv)
if(EXISTS ${out}/marked/pendulum.interrupted.npy)
  message(SEND_ERROR "a whole ensemble is beside the one before")
endif()
file(WRITE ${out}/far.csv "q,g,k[0]\n40,9.81,1000\n")
run(1 far far.csv)
expect("1 failed")
# An older file, of another size, is no result.
file(WRITE ${out}/three/pendulum.npy "something else")
# On machines whose registers have one number, two, and as many as here.
set(ranks 2 0 1)
set(widths 1 2 "")
foreach(rank width IN ZIP_LISTS ranks widths)
  run(0 three members.csv OMPI_COMM_WORLD_RANK=${rank} OMPI_COMM_WORLD_SIZE=3 HILGER_LANES=${width})
endforeach()
file(SHA256 ${out}/one/pendulum.npy one)
file(SHA256 ${out}/three/pendulum.npy three)
if(NOT one STREQUAL three)
  message(SEND_ERROR "three processes wrote another file than one")
endif()
run(0 three members.csv OMPI_COMM_WORLD_RANK=7 OMPI_COMM_WORLD_SIZE=9) # one of them again, on its own
file(SHA256 ${out}/three/pendulum.npy three)
if(NOT one STREQUAL three)
  message(SEND_ERROR "a process that writes its part again changed the others")
endif()
run(0 three members.csv OMPI_COMM_WORLD_RANK=0 OMPI_COMM_WORLD_SIZE=9)
expect("pendulum: none of 7, mid-point")

# same_end(<scene> <its name> <array> <state>): the last q and p of a run are state number so many of an array.
function(same_end scene name array state)
  execute_process(COMMAND ${hilger} run ${scene} --out alone --every 100 WORKING_DIRECTORY ${out} RESULT_VARIABLE result OUTPUT_QUIET)
  file(STRINGS ${out}/alone/${name}.csv rows)
  list(GET rows -1 row)
  math(EXPR at "128 + ${state} * 2 * 8")
  execute_process(COMMAND env LC_ALL=C od -A n -t f8 -j ${at} -N 16 ${out}/${array} OUTPUT_VARIABLE numbers)
  execute_process(COMMAND env LC_ALL=C awk -v "row=${row}" -v "numbers=${numbers}" "BEGIN { split(row, x, \",\"); split(numbers, y, \" \"); print x[2], y[1], x[3], y[2]; exit !((x[2] - y[1])^2 < 1e-24 && (x[3] - y[2])^2 < 1e-24 && x[2]^2 > 1e-4) }"
    RESULT_VARIABLE differs OUTPUT_VARIABLE all_four)
  if(NOT differs EQUAL 0)
    message(SEND_ERROR "the run of ${scene} alone ends in other numbers than the member: ${all_four}")
  endif()
endfunction()
# Member 1 is the file's own problem; so it is of what remembers.
same_end(pendulum.toml pendulum one/pendulum.npy 9)
# Initial values that are formulas of what members bring; an own value of a member is its own.
file(WRITE ${out}/formulas.toml "lagrangian = 'v^2/2 - k*q^2/2'\nparameters = { k = 1 }\ninterval = [0, 3]\nsteps = 30\ninitial = { q = 'k/4', v = 'k + i' }\n")
file(READ ${out}/formulas.toml text)
string(REPLACE "k = 1" "k = 4" text "${text}")
file(WRITE ${out}/four.toml "${text}")
string(REPLACE "q = 'k/4'" "q = 3" text "${text}")
file(WRITE ${out}/own.toml "${text}")
file(WRITE ${out}/brought.csv "k,q\n1,0.25\n4,3\n")
file(WRITE ${out}/only_k.csv "k\n1\n4\n")
foreach(table IN ITEMS only_k brought)
  execute_process(COMMAND ${hilger} run formulas.toml --ensemble ${table}.csv --out ${table} WORKING_DIRECTORY ${out} RESULT_VARIABLE result
    OUTPUT_QUIET)
endforeach()
same_end(formulas.toml formulas only_k/formulas.npy 1)
same_end(four.toml four only_k/formulas.npy 3)
same_end(own.toml own brought/formulas.npy 3)
# So is a number of an embedding.
execute_process(COMMAND ${hilger} run formulas.toml --ensemble only_k.csv --out numbers
  --embedding "integral(L((1 - k/8)*q + k/8*sigma[q], Delta_plus[q]))" WORKING_DIRECTORY ${out} RESULT_VARIABLE result OUTPUT_QUIET)
file(WRITE ${out}/with_number.toml "embedding = 'theta:0.5'\n")
file(READ ${out}/four.toml text)
file(APPEND ${out}/with_number.toml "${text}")
same_end(with_number.toml with_number numbers/formulas.npy 3)
file(WRITE ${out}/at_rest.csv "u,v\n1,0\n0,0\n")
execute_process(COMMAND ${hilger} run fractional-oscillator --ensemble at_rest.csv --out one WORKING_DIRECTORY ${out} RESULT_VARIABLE result
  OUTPUT_QUIET)
same_end(fractional-oscillator fractional-oscillator one/fractional-oscillator.npy 3)

function(says members sentence)
  file(WRITE ${out}/wrong.csv "${members}")
  run(1 wrong wrong.csv)
  if(NOT said STREQUAL "hilger: ${sentence}\n")
    message(SEND_ERROR "expected: hilger: ${sentence}\nsaid: ${said}")
  endif()
  if(EXISTS ${out}/wrong)
    message(SEND_ERROR "something was written")
  endif()
endfunction()
says("q,x\n1,2\n" "wrong.csv, line 1: 'x' is no coordinate, velocity or parameter: there are g, k[], m, q, t, v")
says("q,t\n1,2\n" "wrong.csv, line 1: 't' is the time, and all members begin where the interval of the file does")
says("" "wrong.csv, line 1: the first line names columns, as 'q, v', and this file is empty")
says("q,k\n1,2\n" "wrong.csv, line 1: 'k' is none of the components of k, k[0] to k[1]")
says("q,k[2]\n1,2\n" "wrong.csv, line 1: 'k[2]' is none of the components of k, k[0] to k[1]")
says("q,q[0]\n1,2\n" "wrong.csv, line 1: 'q[0]' is none of the components of q, q")
says("q,q\n1,2\n" "wrong.csv, line 1: 'q' is there twice")
says("q,v\n1,2\n1\n" "wrong.csv, line 3: there are 2 columns, and here are 1")
says("q,v\n1,two\n" "wrong.csv, line 2: a number was expected, as 1, 0.5 or 1/3, and here is 'two'")
says("q,v\n1 5,2\n" "wrong.csv, line 2: a number was expected, as 1, 0.5 or 1/3, and here is '1 5'")
says("q,v\n" "'wrong.csv' has no members: below the names there is a row for each")
run(1 wrong nowhere.csv)
expect("cannot read members from 'nowhere.csv'")
execute_process(COMMAND ${hilger} run fractional-dirichlet --ensemble members.csv --out wrong WORKING_DIRECTORY ${out} RESULT_VARIABLE result
  ERROR_VARIABLE said)
expect("--ensemble is of initial values, and fractional-dirichlet is solved between two ends")
