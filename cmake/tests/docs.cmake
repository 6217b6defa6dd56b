# What the pages show is true: each of their programs is compiled, links what its headers say, and prints what is printed
# below it; and the compiler still says what README.md prints. check_docs.cmake sees that no block is passed over.
include(doc_blocks)
file(GLOB_RECURSE pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/docs/*.md)
list(PREPEND pages ${PROJECT_SOURCE_DIR}/README.md)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${pages})

# A number may differ by one in the sixth digit, the last that is printed.
set(tolerance "# rel 1e-5 abs 1e-12")

foreach(page IN LISTS pages)
  doc_blocks(block ${page})
  cmake_path(GET page STEM name)
  string(TOLOWER ${name} name)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/docs/${name})
  set(number 0)
  foreach(i RANGE ${block_COUNT})
    set(kind "${block_${i}_KIND}")
    set(text "${block_${i}_TEXT}")
    if(i EQUAL block_COUNT)
      break()
    elseif(kind STREQUAL "csv")
      file(CONFIGURE OUTPUT ${folder}/${block_${i}_OF} CONTENT "${text}" @ONLY)
    elseif(kind STREQUAL "cpp" AND block_${i}_OF STREQUAL "")
      math(EXPR number "${number} + 1")
      set(program doc_${name}_${number})
      file(CONFIGURE OUTPUT ${folder}/${number}.cpp CONTENT "#line ${block_${i}_LINE} \"${page}\"\n${text}" @ONLY)
      add_executable(${program} ${folder}/${number}.cpp)
      set(layer frames)
      foreach(upper kinematics space dynamics)
        if(text MATCHES "<vectrix/${upper}")
          set(layer ${upper})
        endif()
      endforeach()
      target_link_libraries(${program} PRIVATE vectrix::${layer})
      vectrix_warnings(${program})
    elseif(kind STREQUAL "text")
      file(CONFIGURE OUTPUT ${folder}/${number}.txt CONTENT "${tolerance}\n${text}" @ONLY)
      add_test(NAME docs.${name}.${number} WORKING_DIRECTORY ${folder}
               COMMAND compare_output ${folder}/${number}.txt $<TARGET_FILE:${program}>)
    endif()
  endforeach()
endforeach()

set(check ${CMAKE_COMMAND} -D ROOT=${PROJECT_SOURCE_DIR})
add_test(NAME hygiene.docs COMMAND ${check} -P ${scripts}/check_docs.cmake)
foreach(lie "docs_sample.md:8: no main" "docs_sample.md:12: 'README.md' is no program" "docs_sample.md:16: there is no examples/"
            "docs_sample.md:20: examples/wrong_frame.cpp does not have" "docs_sample.md:25: no program stands before"
            "docs_sample.md:29: a csv block needs" "docs_sample.md:33: no test reads a block of the kind 'sh'"
            "docs_sample.md:49: a program comes before this" "docs_sample.md:53: no test reads .* 'unclosed'" "dcm_test.cpp has no Dcm.NoSuchTest" "10 violations")
  string(MAKE_C_IDENTIFIER "${lie}" name)
  add_test(NAME hygiene.docs.finds.${name} COMMAND ${check} -D PAGES=${scripts}/docs_sample.md -P ${scripts}/check_docs.cmake)
  set_tests_properties(hygiene.docs.finds.${name} PROPERTIES PASS_REGULAR_EXPRESSION "${lie}")
endforeach()

# The message in README.md is g++'s.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(includes ${PROJECT_SOURCE_DIR}/frames/include)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  add_test(NAME readme.refusal COMMAND ${CMAKE_COMMAND} -D COMPILER=${CMAKE_CXX_COMPILER} "-DINCLUDES=${includes};${eigen}"
                                       -D MODE=check -P ${PROJECT_SOURCE_DIR}/cmake/readme.cmake)
endif()
