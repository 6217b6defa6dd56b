# Tests of the code on the pages: each program is compiled, links the libraries that its headers need, and prints the
# output shown below it; and the compiler still prints the message shown in README.md. check_docs.py checks that no
# block is skipped.
set(folder ${CMAKE_CURRENT_BINARY_DIR}/docs)
execute_process(COMMAND ${Python3_EXECUTABLE} ${tools}/doc_programs.py --folder ${folder} --layers ${VECTRIX_LAYERS}
                COMMAND_ERROR_IS_FATAL ANY)

# The first program that uses the headers of a layer precompiles them for the others.
function(doc_program page number layer headers)
  if(NOT TARGET vectrix_${layer})
    return()  # it is not built
  endif()
  set(program doc_${page}_${number})
  add_executable(${program} ${folder}/${page}/${number}.cpp)
  target_link_libraries(${program} PRIVATE vectrix::${layer})
  vectrix_warnings(${program})
  target_compile_options(${program} PRIVATE -O0)  # their printed numbers are tested, and compiling takes half the time
  if(headers STREQUAL "PRECOMPILED")
    get_property(first GLOBAL PROPERTY doc_headers_of_${layer})
    if(first)
      target_precompile_headers(${program} REUSE_FROM ${first})
    else()
      target_precompile_headers(${program} PRIVATE <vectrix/${layer}.hpp>)
      set_property(GLOBAL PROPERTY doc_headers_of_${layer} ${program})
    endif()
  endif()
  # Like a reader, it runs where examples/data is.
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/examples ${folder}/${page}/examples SYMBOLIC)
  add_test(NAME docs.${page}.${number} WORKING_DIRECTORY ${folder}/${page}
           COMMAND compare_output ${folder}/${page}/${number}.txt $<TARGET_FILE:${program}>)
endfunction()

function(doc_commands page number)
  if(NOT TARGET vectrix_program)
    return()
  endif()
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/examples ${folder}/${page}/examples SYMBOLIC)
  add_test(NAME docs.${page}.${number} WORKING_DIRECTORY ${folder}/${page}
           COMMAND ${CMAKE_COMMAND} -E env PATH=$<TARGET_FILE_DIR:vectrix_program>:$ENV{PATH}
                   $<TARGET_FILE:compare_output> ${folder}/${page}/${number}.txt sh ${folder}/${page}/${number}.sh)
  # Commands may use the files of those before.
  math(EXPR before "${number} - 1")
  set_tests_properties(docs.${page}.${number} PROPERTIES DEPENDS docs.${page}.${before})
endfunction()

include(${folder}/programs.cmake)
file(GLOB_RECURSE found CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${doc_pages} ${tools}/doc_programs.py ${tools}/doc_blocks.py)

add_test(NAME hygiene.docs COMMAND ${Python3_EXECUTABLE} ${tools}/check_docs.py)

# The message in README.md is that of g++.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  add_test(NAME readme.refusal COMMAND ${Python3_EXECUTABLE} ${tools}/readme.py --compiler ${CMAKE_CXX_COMPILER}
                                       --include ${PROJECT_SOURCE_DIR}/frames/include ${eigen})
endif()
