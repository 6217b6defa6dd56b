# Tests of single compiler calls, without objects: programs that must be refused, headers that must compile alone.
set(VECTRIX_REFUSALS_TOOL ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/refusals.py)
set(VECTRIX_SYNTAX ${CMAKE_BINARY_DIR}/syntax)

# The compiler's options for the public headers, in ${VECTRIX_SYNTAX}/{plain,strict}.options (strict: warnings are errors).
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
  separate_arguments(flags NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
  set(plain ${flags} -std=c++20 -Wpedantic ${own} ${system})  # g++ shares no precompiled header with a less pedantic call
  set(strict ${plain} ${VECTRIX_WARNINGS} -Werror)
  foreach(set plain strict)
    list(JOIN ${set} "\n" text)
    file(GENERATE OUTPUT ${VECTRIX_SYNTAX}/${set}.options CONTENT "${text}\n")
  endforeach()
endfunction()

# The call that compiles the headers of all layers, once for all refused programs.
function(vectrix_precompile_layers command)
  set(lines)
  foreach(layer IN LISTS VECTRIX_LAYERS)
    if(TARGET vectrix_${layer})
      string(APPEND lines "#include <vectrix/${layer}.hpp>\n")
    endif()
  endforeach()
  set(header ${VECTRIX_SYNTAX}/layers.hpp)
  file(CONFIGURE OUTPUT ${header} CONTENT "${lines}")
  # Otherwise clang instantiates what the headers use in each call that includes them.
  set(once)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    set(once -fpch-instantiate-templates)
  endif()
  set(${command} ${CMAKE_CXX_COMPILER} @${VECTRIX_SYNTAX}/plain.options ${once} -x c++-header ${header} -o ${header}.gch PARENT_SCOPE)
endfunction()

# The test refused.headers, which the other tests of refused programs need.
function(vectrix_refused_headers_test)
  vectrix_precompile_layers(precompile)
  add_test(NAME refused.headers COMMAND ${precompile})
  set_tests_properties(refused.headers PROPERTIES FIXTURES_SETUP refused.headers COST 50)
endfunction()

# The files of refused programs of a layer.
function(vectrix_refused_files variable layer)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${layer}/tests/*.cpp)
  list(FILTER files INCLUDE REGEX "/refused/[^/]*$")
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

# A test refused.<layer>.<topic> for each file of refused programs. What the compiler says of them is kept for the test
# of docs/reference/refusals.md.
function(vectrix_refused_tests layer)
  vectrix_refused_files(files ${layer})
  if(NOT files)
    return()
  endif()
  foreach(file IN LISTS files)
    cmake_path(GET file STEM topic)
    add_test(NAME refused.${layer}.${topic}
             COMMAND ${VECTRIX_REFUSALS_TOOL} check --limit-length --compiler ${CMAKE_CXX_COMPILER} --options ${VECTRIX_SYNTAX}/plain.options
                     --strict ${VECTRIX_SYNTAX}/strict.options --precompiled ${VECTRIX_SYNTAX}/layers.hpp
                     --save ${CMAKE_BINARY_DIR}/refused ${file})
    set_tests_properties(refused.${layer}.${topic} PROPERTIES FIXTURES_REQUIRED refused.headers
                                                              FIXTURES_SETUP refused.messages COST 10)
  endforeach()
endfunction()

# The test that docs/reference/refusals.md is what the refused programs give; its messages are those of g++ 12.
function(vectrix_refusals_page_test)
  if("${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" MATCHES "^GNU 12[.]")
    set(all)
    foreach(layer IN LISTS VECTRIX_LAYERS)
      vectrix_refused_files(files ${layer})
      if(files AND NOT TARGET vectrix_${layer})
        return()  # the page tells of every refused program
      endif()
      list(APPEND all ${files})
    endforeach()
    add_test(NAME hygiene.refusals COMMAND ${VECTRIX_REFUSALS_TOOL} page --messages ${CMAKE_BINARY_DIR}/refused ${all})
    set_tests_properties(hygiene.refusals PROPERTIES FIXTURES_REQUIRED refused.messages)
  endif()
endfunction()

# The target refusals, which writes docs/reference/refusals.md.
function(vectrix_refusals_target)
  set(messages)
  set(all)
  set(headers)
  foreach(layer IN LISTS VECTRIX_LAYERS)
    file(GLOB_RECURSE own CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${layer}/include/*.hpp)
    list(APPEND headers ${own})
  endforeach()
  vectrix_precompile_layers(precompile)
  add_custom_command(OUTPUT ${VECTRIX_SYNTAX}/layers.hpp.gch DEPENDS ${headers} COMMAND ${precompile})
  foreach(layer IN LISTS VECTRIX_LAYERS)
    vectrix_refused_files(files ${layer})
    list(APPEND all ${files})
    foreach(file IN LISTS files)
      cmake_path(GET file STEM topic)
      set(message ${CMAKE_BINARY_DIR}/refused/${layer}.${topic}.json)
      add_custom_command(OUTPUT ${message} DEPENDS ${VECTRIX_SYNTAX}/layers.hpp.gch ${file}
                         COMMAND ${VECTRIX_REFUSALS_TOOL} messages --compiler ${CMAKE_CXX_COMPILER} --options ${VECTRIX_SYNTAX}/plain.options
                                 --precompiled ${VECTRIX_SYNTAX}/layers.hpp --save ${CMAKE_BINARY_DIR}/refused ${file})
      list(APPEND messages ${message})
    endforeach()
  endforeach()
  add_custom_target(refusals COMMAND ${VECTRIX_REFUSALS_TOOL} page --write --messages ${CMAKE_BINARY_DIR}/refused ${all}
                    DEPENDS ${messages})
endfunction()
