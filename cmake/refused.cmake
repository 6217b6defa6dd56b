# Tests of single compiler calls, without objects: programs that must be refused, headers that must compile alone.

# The compiler's options for the public headers, in ${CMAKE_BINARY_DIR}/syntax/{plain,strict}.options (strict: warnings are errors).
function(vectrix_syntax_options)
  set(system)
  foreach(target Eigen3::Eigen Boost::headers)
    get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
    list(APPEND system ${folders})
  endforeach()
  list(REMOVE_ITEM system ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES})
  list(TRANSFORM system PREPEND "-isystem ")
  set(own ${VECTRIX_LAYERS})
  list(TRANSFORM own REPLACE "(.+)" "-I${PROJECT_SOURCE_DIR}/\\1/include")
  set(plain -std=c++20 -Wpedantic ${own} ${system})  # g++ shares no precompiled header with a less pedantic call
  set(strict ${plain} ${VECTRIX_WARNINGS} -Werror)
  foreach(set plain strict)
    list(JOIN ${set} "\n" text)
    file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/syntax/${set}.options CONTENT "${text}\n")
  endforeach()
endfunction()

# The test refused.<layer>.<name> of a program that contains a mistake; check_refused.cmake says what it demands.
# A layer's headers are compiled once for all its programs, by the fixture refused.<layer>.
function(vectrix_refused layer program)
  cmake_path(GET program STEM name)
  set(page)
  if(NOT layer STREQUAL "harness" AND "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" MATCHES "^GNU 12[.]")
    set(page -D PAGE=${PROJECT_SOURCE_DIR}/docs/refusals.md)  # its messages are those of g++ 12
  endif()
  add_test(NAME refused.${layer}.${name}
           COMMAND ${CMAKE_COMMAND} -D COMPILER=${CMAKE_CXX_COMPILER} -D OPTIONS=${CMAKE_BINARY_DIR}/syntax
                   -D LAYER=${layer} -D PROGRAM=${program} ${page}
                   -P ${PROJECT_SOURCE_DIR}/cmake/check_refused.cmake)
  set_tests_properties(refused.${layer}.${name} PROPERTIES FIXTURES_REQUIRED refused.${layer})
endfunction()

function(vectrix_refused_layer layer)
  set(header ${CMAKE_BINARY_DIR}/syntax/${layer}.hpp)
  file(CONFIGURE OUTPUT ${header} CONTENT "#include <vectrix/${layer}.hpp>\n")
  add_test(NAME refused.${layer} COMMAND ${CMAKE_CXX_COMPILER} @${CMAKE_BINARY_DIR}/syntax/plain.options
                                         -x c++-header ${header} -o ${header}.gch)
  set_tests_properties(refused.${layer} PROPERTIES FIXTURES_SETUP refused.${layer} COST 50)
endfunction()
