# SPDX-License-Identifier: BSL-1.0
# cmake -D hilger=<program> -D out=<directory> -P observed.cmake
# What a file looks at is in its rows and pictures, and what it is measured with is what `hilger trade` measures with.
file(REMOVE_RECURSE ${out})
file(WRITE ${out}/oscillator.toml [[
coordinates = "q[2]"
velocities = "v[2]"
lagrangian = "dot(v, v)/2 - dot(q, q)/2"
parameters = { n = 4 }
interval = [0, "1/2"]
steps = 16
units = "s"
initial = { q = "n*(i + 1)/8", v = 0 }
conserved = { "twice the energy" = "dot(q, q) + dot(v, v)", "what falls" = "v[0]" }
observed = { double = "2*q[1]", time = "-t", "to a pole" = "1/t" }
pictures = [{ title = "Twice", x = "q_1", y = ["double", "time"] }]
exact = { position = ["0.438791280945186357930", "0.877582561890372716116"], source = "half a cosine and one", error = 1e-20 }
]])
function(expect what in)
  if(NOT "${${in}}" MATCHES "${what}")
    message(SEND_ERROR "expected ${what} in ${${in}}")
  endif()
endfunction()
execute_process(COMMAND ${hilger} run oscillator.toml --out rows WORKING_DIRECTORY ${out} OUTPUT_VARIABLE said ERROR_VARIABLE said)
expect("t = 0 to 0.5 s, .*largest error of energy: [0-9.e-]+\n +largest error of twice the energy: [0-9.e-]+\n" said)
expect("largest error of what falls: 0.24[0-9]*\n  to a pole is NaN or infinite in some rows\n" said) # sin(1/2)/2, and so it does not stay
file(STRINGS ${out}/rows/oscillator.csv rows)
list(LENGTH rows count)
if(NOT count EQUAL 18)
  message(SEND_ERROR "${count} lines, and a heading and 17 points were expected")
endif()
list(GET rows 0 heading)
expect("^# t,q_0,q_1,p_q_0,p_q_1,energy error,twice the energy error,what falls error,double,time,to a pole$" heading)
list(GET rows 1 first)
expect("^0,0.5,1,0,0,0,0,0,2,-?0,inf$" first)
list(GET rows 17 last)
string(REPLACE "," ";" last "${last}")
list(GET last 9 time)
expect("^-0.5$" time)
# energy and twice of it, q and twice of it
foreach(pair IN ITEMS "5;6" "2;8")
  list(GET pair 0 one)
  list(GET pair 1 two)
  list(GET last ${one} single)
  list(GET last ${two} double)
  execute_process(COMMAND env LC_ALL=C awk "BEGIN { d = 2 * ${single} - ${double}; exit d * d > 1e-30 }" RESULT_VARIABLE differs)
  if(differs)
    message(SEND_ERROR "${double} is not twice ${single}")
  endif()
endforeach()
file(READ ${out}/rows/oscillator.gp picture)
expect("set key noenhanced; set title 'Twice' noenhanced; set size noratio; set xlabel 'q_1' noenhanced; set ylabel '' noenhanced\nplot 'oscillator.csv' using 3:9 with lines title 'double', 'oscillator.csv' using 3:10 with lines title 'time'\n" picture)
expect("size 750,720.*set multiplot layout 1,1\n" picture) # one plot, and no room for another
find_program(gnuplot gnuplot)
if(gnuplot)
  execute_process(COMMAND ${hilger} run oscillator.toml --out rows WORKING_DIRECTORY ${out} OUTPUT_VARIABLE shown)
  expect("\\+-----" shown)
  string(ASCII 12 page)
  execute_process(COMMAND ${hilger} run damped-pendulum --out rows WORKING_DIRECTORY ${out} OUTPUT_VARIABLE scribble)
  if("${shown}" MATCHES "${page}" OR "${scribble}" MATCHES "[+]-----")
    message(SEND_ERROR "a form feed, or a curve of 25 periods in letters")
  endif()
endif()
# Names that a shell or gnuplot would take for something else.
file(READ ${out}/oscillator.toml text)
file(WRITE "${out}/my 'own'.toml" "${text}")
execute_process(COMMAND ${hilger} run "my 'own'.toml" --out "the 'rows'" WORKING_DIRECTORY ${out} OUTPUT_VARIABLE said ERROR_VARIABLE said)
expect("Twice.*Written: the 'rows'/my__own_.csv" said)
file(APPEND ${out}/oscillator.toml "force = [\"0*v[0]\", \"0\"]\n") # which has few methods
execute_process(COMMAND ${hilger} trade oscillator.toml --budget 0.0005 --out rows WORKING_DIRECTORY ${out} OUTPUT_VARIABLE said ERROR_VARIABLE said)
expect("against half a cosine and one, itself within 1e-20" said)
expect("[0-9.]+e-1[5-9] +[0-9.]+ ms" said)

# What is no number is none in JSON; and a file names any history that there is.
file(WRITE ${out}/none.toml "lagrangian = 'v^2/2 - q^2/2'\ndamping = [ { rho = 1, alpha = 0.5 } ]\nembedding = 'gl-newmark'\nhistory = 'exponentials:1e-7'\ninterval = [0, 1]\nsteps = 20\ninitial = { q = 1, v = 0 }\nobserved = { z = 'log(q - 2)' }\n")
execute_process(COMMAND ${hilger} run none.toml --out rows WORKING_DIRECTORY ${out} OUTPUT_VARIABLE said ERROR_VARIABLE said)
expect("none: gl-newmark, exponentials:1e-7, double, 20 steps" said)
file(READ ${out}/rows/none.json summary)
string(JSON kind ERROR_VARIABLE wrong TYPE "${summary}" last 3)
if(NOT wrong STREQUAL "NOTFOUND" OR NOT kind STREQUAL "NULL")
  message(SEND_ERROR "null was expected and is ${kind} (${wrong}) in ${summary}")
endif()
file(READ ${out}/none.toml text)
string(REPLACE "exponentials:1e-7" "window:7" text "${text}")
file(WRITE ${out}/none.toml "${text}")
execute_process(COMMAND ${hilger} run none.toml --out rows WORKING_DIRECTORY ${out} OUTPUT_VARIABLE said ERROR_VARIABLE said)
expect("line 4, column 11: the history is one of exponentials, exponentials:1e-8, blocks, direct here, and not 'window:7'" said)

# In a transformed time rows are in t, and the energy is that of L.
file(WRITE ${out}/orbit.toml [[
coordinates = ["x", "y"]
velocities = ["vx", "vy"]
lagrangian = "(vx^2 + vy^2)/2 + 1/hypot(x, y)"
time_transformation = "sundman(1)"
interval = [0, "2*pi"]
steps = 64
embedding = "gauss-4"
initial = { x = "1/10", y = 0, vx = 0, vy = "sqrt(19)" }
]])
execute_process(COMMAND ${hilger} run orbit.toml --out rows WORKING_DIRECTORY ${out} OUTPUT_VARIABLE said ERROR_VARIABLE said)
expect("largest error of energy: [0-9.]+e-[01][0-9]\n" said)
file(STRINGS ${out}/rows/orbit.csv rows)
list(GET rows 33 aphelion)
expect("^3.14159265[0-9]+,-1.9000000000" aphelion)
list(GET rows 65 perihelion)
expect("^6.283185307[0-9]+,0.(09999999999|1)" perihelion)
