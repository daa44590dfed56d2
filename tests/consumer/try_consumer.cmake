# cmake -DBUILD= -DPROJECT= -DWORK= -DWORLD= -DCOMPILER= -DGENERATOR= [-DFLAGS=] -P try_consumer.cmake
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
run("${prefix}/bin/aisle" sim log "${WORLD}" --out "${WORK}/sim")
execute_process(COMMAND "${WORK}/build/consumer" "${WORK}/sim/simulated-trip.log"
  OUTPUT_VARIABLE said COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
if(NOT said MATCHES "^[1-9][0-9]* walls")
  message(FATAL_ERROR "the consumer made no map: ${said}")
endif()
