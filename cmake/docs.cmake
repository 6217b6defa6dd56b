# The target docs: the reference from the docstrings, in ${CMAKE_BINARY_DIR}/docs/html.
find_package(Doxygen REQUIRED)
set(DOXYGEN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/docs)
set(DOXYGEN_PROJECT_NAME Vectrix)
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/README.md)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR})
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_HAVE_DOT NO)
doxygen_add_docs(docs frames/include kinematics/include dynamics/include docs README.md
                 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})

# The compiler's message in README.md.
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
add_custom_target(readme COMMAND ${CMAKE_COMMAND} -D COMPILER=${CMAKE_CXX_COMPILER}
                                 "-DINCLUDES=${PROJECT_SOURCE_DIR}/frames/include;${eigen}" -D MODE=write
                                 -P ${PROJECT_SOURCE_DIR}/cmake/readme.cmake VERBATIM)
add_dependencies(docs readme)
