# SPDX-License-Identifier: BSL-1.0
# cmake -D hilger=<program> -D out=<directory> -P ranks.cmake
# Four ranks of MPI, the registers of one of which have fewer numbers, write the file of one process to the last byte.
file(REMOVE_RECURSE ${out})
find_program(mpirun mpirun)
if(NOT mpirun)
  message("skipped: there is no mpirun")
  return()
endif()
file(WRITE ${out}/pendulum.toml "lagrangian = 'v^2/2 - g*(1 - cos(q))'\nparameters = { g = 9.81 }\ninterval = [0, 4]\nsteps = 100\ninitial = { q = 2, v = '1/3' }\n")
file(WRITE ${out}/members.csv "q,g\n1,9.81\n2,9.81\n0.5,1/2\n1.5,1.6\n-1,3\n0.25,9\n3,0.25\n")
set(run ${hilger} run pendulum.toml --ensemble members.csv --every 30 --out)
execute_process(COMMAND ${run} one WORKING_DIRECTORY ${out} RESULT_VARIABLE alone OUTPUT_QUIET)
execute_process(COMMAND ${mpirun} --allow-run-as-root --oversubscribe -n 3 ${run} four : -n 1 -x HILGER_LANES=2 ${run} four
  WORKING_DIRECTORY ${out} RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE complained)
file(SHA256 ${out}/one/pendulum.npy one)
file(SHA256 ${out}/four/pendulum.npy four)
if(NOT alone EQUAL 0 OR NOT result EQUAL 0 OR NOT one STREQUAL four)
  message(SEND_ERROR "four ranks wrote another file than one (${alone}, ${result}): ${complained}")
endif()
