# cmake -DBUILD= -DPROJECT= -DWORK= -DCOMPILER= -DGENERATOR= [-DFLAGS=] -P try_consumer.cmake
function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(prefix "${WORK}/prefix")
file(REMOVE_RECURSE "${WORK}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${prefix}")

# What only the build of aisle itself needs must not reach the projects of others.
file(GLOB_RECURSE exported "${prefix}/*/cmake/aisle/*.cmake")
if(NOT exported)
  message(FATAL_ERROR "no package files were installed")
endif()
foreach(file IN LISTS exported)
  file(READ "${file}" text)
  foreach(leak "${BUILD}" "-Werror" "-march" "/modules/")
    string(FIND "${text}" "${leak}" found)
    if(NOT found EQUAL -1)
      message(FATAL_ERROR "${file} mentions ${leak}")
    endif()
  endforeach()
endforeach()

run("${CMAKE_COMMAND}" -S "${PROJECT}" -B "${WORK}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_FLAGS=${FLAGS}")
run("${CMAKE_COMMAND}" --build "${WORK}/build")

# The installed program finds its way without the build as well.
run("${prefix}/bin/aisle" sim log small-office --out "${WORK}/sim")
run("${prefix}/bin/aisle" explore l-corridor --out "${WORK}/explored" --quiet)
run("${prefix}/bin/aisle" sim render l-corridor --out "${WORK}/view.png")

# try(EXAMPLE REGEX ARGUMENT...): it ends well and says what matches.
function(try example regex)
  execute_process(COMMAND "${WORK}/build/${example}" ${ARGN}
    OUTPUT_VARIABLE said COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
  if(NOT said MATCHES "${regex}")
    message(FATAL_ERROR "${example} said: ${said}")
  endif()
endfunction()
set(in_l "${prefix}/share/aisle/worlds/l-corridor.yaml" "${prefix}/share/aisle/vehicles/alv-scanner.yaml")
try(01_map_a_log "[1-9][0-9]* walls" "${WORK}/sim/simulated-trip.log" "${WORK}/building.json")
try(02_look_into_a_building "place 'home'.*m2 of free floor" "${WORK}/explored/building.json" "${WORK}/building.png")
try(03_find_vertical_lines "side brighter" "${WORK}/view.png")
try(04_drive_in_the_simulator "with 0 collisions" ${in_l})
try(05_write_a_navigator "there after [1-9]" ${in_l})
try(06_explore_a_building "explored: .* 0 collisions, home again" ${in_l} "${WORK}/explored.png")
try(07_go_to_a_place "arrived .*after [1-9]" "${WORK}/explored/building.json" ${in_l} 12.8 5)
