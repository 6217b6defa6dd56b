# Checks that the dynamic linker loads the libraries of PROGRAM in the order named by ORDER: vectrix_first or
# simbody_first.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${READELF} -d ${PROGRAM} OUTPUT_VARIABLE needed COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${needed}" "[libvectrix_dynamics.so" vectrix)
string(FIND "${needed}" "[libSimTKmath.so" simbody)
if(vectrix LESS simbody)
  set(found vectrix_first)
else()
  set(found simbody_first)
endif()
if(vectrix EQUAL -1 OR simbody EQUAL -1 OR NOT found STREQUAL ORDER)
  message(FATAL_ERROR "${PROGRAM} is not ${ORDER}:\n${needed}")
endif()
