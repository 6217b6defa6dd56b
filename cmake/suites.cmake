# Read by ctest when it starts: a test <layer>.<suite> for each suite of the program of tests of a layer. All tests of a suite
# share one process: a process for each test would load the libraries three thousand times. The suites of one template, and
# those with one set of parameters, share a process too.
if(NOT EXISTS "${program}")
  add_test("${layer}.tests_are_not_built" "${program}")
  return()
endif()
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE listed RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${program} does not list its tests: ${status}")
endif()
string(REGEX MATCHALL "(^|\n)[A-Za-z0-9_/]+[.]" listed "${listed}")
set(suites)
foreach(name IN LISTS listed)
  string(REGEX REPLACE "[\n.]" "" name "${name}")
  string(REGEX REPLACE "/[0-9]+$" "" suite "${name}")  # of a template: Suite/0
  string(REGEX REPLACE "^.*/" "" suite "${suite}")     # with parameters: Set/Suite
  list(APPEND suites ${suite})
  string(APPEND tests_of_${suite} "${name}.*:")
endforeach()
list(REMOVE_DUPLICATES suites)
foreach(suite IN LISTS suites)
  add_test("${layer}.${suite}" "${program}" "--gtest_filter=${tests_of_${suite}}")
  set_tests_properties("${layer}.${suite}" PROPERTIES TIMEOUT 600)
  unset(tests_of_${suite})
endforeach()
