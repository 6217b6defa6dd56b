# The target docs: the reference from the docstrings, in ${CMAKE_BINARY_DIR}/docs/html.
find_package(Doxygen REQUIRED)
set(DOXYGEN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/docs)
set(DOXYGEN_PROJECT_NAME Vectrix)
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/README.md)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR})
set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR}/docs)
# Doxygen 1.9.4 cannot resolve ../pictures/<file>, docs/pictures/<file> or <page>.md#<section>: give it pictures/<file> and
# <page>.md.
set(DOXYGEN_FILTER_PATTERNS "*.md=sed -e s,[.][.]/pictures/,pictures/, -e s,docs/pictures/,pictures/, -e s,[.]md#[-a-z0-9]*,.md,g")
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_HAVE_DOT NO)
list(TRANSFORM VECTRIX_LAYERS APPEND /include OUTPUT_VARIABLE headers)
doxygen_add_docs(docs ${headers} docs README.md CHANGELOG.md WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})

# docs/pictures.
if(TARGET draw_pictures)
  add_dependencies(docs draw_pictures)
endif()

# docs/reference/scenario_file.md, result_file.md and those of the commands.
if(TARGET reference_pages)
  add_dependencies(docs reference_pages)
endif()

# The compiler's message in README.md.
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
add_custom_target(readme COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/tools/readme.py --write
                                 --compiler ${CMAKE_CXX_COMPILER} --include ${PROJECT_SOURCE_DIR}/frames/include ${eigen}
                  VERBATIM)
add_dependencies(docs readme)

# docs/reference/refusals.md.
if(NOT VECTRIX_REFUSED_TESTS AND NOT VECTRIX_HYGIENE_TESTS)
  vectrix_syntax_options()
endif()
vectrix_refusals_target()
add_dependencies(docs refusals)
