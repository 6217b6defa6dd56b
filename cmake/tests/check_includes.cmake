# The allowed directions of dependence, checked in the #include lines: cmake -D ROOT=<source folder> -P
# check_includes.cmake
#     frames <- kinematics <- space <- dynamics <- examples, pictures, validation, accuracy
# Only space/src includes ERFA, only dynamics/src includes SUNDIALS, and only validation/**/simbody_* and
# bench/peer_simbody.cpp include Simbody.
cmake_minimum_required(VERSION 3.25)
set(kinematics "vectrix/kinematics")
set(space "vectrix/space")
set(dynamics "vectrix/dynamics")
set(erfa "erfa")
set(solvers "sundials/|cvode/|arkode/|nvector/|sunmatrix/|sunlinsol/|sunnonlinsol/")
set(simbody "Simbody|SimTK|simbody/|simmath/|SimTKcommon/")
set(violations 0)

# No include in the files found by <pattern>… may match <forbidden>.
function(forbid forbidden)
  list(TRANSFORM ARGN PREPEND ${ROOT}/)
  file(GLOB_RECURSE files LIST_DIRECTORIES OFF RELATIVE ${ROOT} ${ARGN})
  list(FILTER files INCLUDE REGEX "[.](cpp|hpp)$")
  list(FILTER files EXCLUDE REGEX "^(validation/(tests/)?simbody_[^/]*|bench/peer_simbody[.]cpp)$")
  foreach(file IN LISTS files)
    file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"](${forbidden})")
    foreach(line IN LISTS lines)
      message(NOTICE "${file}: ${line}")
      math(EXPR violations "${violations} + 1")
    endforeach()
  endforeach()
  set(violations ${violations} PARENT_SCOPE)
endfunction()

set(above examples/* pictures/* validation/* accuracy/*)
forbid("${kinematics}|${space}|${dynamics}" frames/*)
forbid("${space}|${dynamics}" kinematics/*)
forbid("${dynamics}" space/* testing/*)
forbid("${erfa}" frames/* kinematics/* space/include/* space/tests/* dynamics/* ${above})
forbid("${solvers}" frames/* kinematics/* space/* dynamics/include/* dynamics/tests/* ${above})
forbid("${simbody}" frames/* kinematics/* space/* dynamics/* ${above} bench/*)

# Public headers also contain no name of the engines (an enumerator such as cvode_adams belongs to this library).
file(GLOB_RECURSE headers RELATIVE ${ROOT} ${ROOT}/frames/include/*.hpp ${ROOT}/kinematics/include/*.hpp
     ${ROOT}/space/include/*.hpp ${ROOT}/dynamics/include/*.hpp)
set(engine_names "CVode|CV_|ARK[oS]|ARK_|ERKStep|SUN[A-Z]|sun[a-z]+type|sundials|N_V|realtype|era[A-Z]|SimTK")
foreach(header IN LISTS headers)
  file(READ ${ROOT}/${header} text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  if(text MATCHES "[^A-Za-z0-9_](${engine_names})[A-Za-z_]*")
    message(NOTICE "${header}: names '${CMAKE_MATCH_0}' in a public header")
    math(EXPR violations "${violations} + 1")
  endif()
endforeach()

if(violations GREATER 0)
  message(FATAL_ERROR "${violations} against the direction of dependence")
endif()
