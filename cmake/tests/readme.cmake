# What README.md shows is true: its program builds and runs, and the compiler still says what is printed there.
file(READ ${PROJECT_SOURCE_DIR}/README.md readme)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/README.md)
string(REGEX MATCH "```cpp\n(#include[^`]*)```" block "${readme}")
file(CONFIGURE OUTPUT readme_program.cpp CONTENT "${CMAKE_MATCH_1}" @ONLY)
add_executable(readme_program ${CMAKE_CURRENT_BINARY_DIR}/readme_program.cpp)
target_link_libraries(readme_program PRIVATE vectrix::dynamics)
vectrix_warnings(readme_program)
add_test(NAME readme.program COMMAND readme_program)
set_tests_properties(readme.program PROPERTIES PASS_REGULAR_EXPRESSION "rad/s")

# The printed message is g++'s.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(includes ${PROJECT_SOURCE_DIR}/frames/include)
  get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
  add_test(NAME readme.refusal COMMAND ${CMAKE_COMMAND} -D COMPILER=${CMAKE_CXX_COMPILER} "-DINCLUDES=${includes};${eigen}"
                                       -D MODE=check -P ${PROJECT_SOURCE_DIR}/cmake/readme.cmake)
endif()
