# The target docs: the reference from the docstrings, in ${CMAKE_BINARY_DIR}/docs/html.
find_package(Doxygen REQUIRED)
set(DOXYGEN_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/docs)
set(DOXYGEN_PROJECT_NAME Vectrix)
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/README.md)
set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR})
set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR}/docs)
# Doxygen 1.9.4 cannot resolve ../pictures/<file> or <page>.md#<section>: give it pictures/<file> and <page>.md.
set(DOXYGEN_FILTER_PATTERNS "*.md=sed -e s,[.][.]/pictures/,pictures/, -e s,[.]md#[-a-z0-9]*,.md,g")
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_HAVE_DOT NO)
doxygen_add_docs(docs frames/include kinematics/include space/include dynamics/include docs README.md
                 WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})

# docs/pictures.
if(TARGET draw_pictures)
  add_dependencies(docs draw_pictures)
endif()

# The compiler's message in README.md.
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
add_custom_target(readme COMMAND ${CMAKE_COMMAND} -D COMPILER=${CMAKE_CXX_COMPILER}
                                 "-DINCLUDES=${PROJECT_SOURCE_DIR}/frames/include;${eigen}" -D MODE=write
                                 -P ${PROJECT_SOURCE_DIR}/cmake/readme.cmake VERBATIM)
add_dependencies(docs readme)

# docs/refusals.md: the compiler is asked about each refused program, as many at a time as the build has jobs.
if(NOT VECTRIX_HYGIENE_TESTS)
  vectrix_syntax_options()
endif()
set(script ${PROJECT_SOURCE_DIR}/cmake/refusals.cmake)
set(syntax ${CMAKE_BINARY_DIR}/syntax)
set(folder ${CMAKE_BINARY_DIR}/refusals)
set(headers)
set(messages)
foreach(layer IN LISTS VECTRIX_LAYERS)
  file(GLOB_RECURSE own CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${layer}/include/*.hpp)
  list(APPEND headers ${own})
  file(CONFIGURE OUTPUT ${syntax}/${layer}.hpp CONTENT "#include <vectrix/${layer}.hpp>\n")
  add_custom_command(OUTPUT ${syntax}/${layer}.hpp.gch DEPENDS ${headers}
                     COMMAND ${CMAKE_CXX_COMPILER} @${syntax}/plain.options -x c++-header ${syntax}/${layer}.hpp
                             -o ${syntax}/${layer}.hpp.gch)
  file(GLOB programs CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/${layer}/tests/refused/*.cpp)
  foreach(program IN LISTS programs)
    cmake_path(GET program STEM name)
    set(message ${folder}/${layer}.${name}.txt)
    add_custom_command(OUTPUT ${message} DEPENDS ${syntax}/${layer}.hpp.gch ${PROJECT_SOURCE_DIR}/${program} ${script}
                       COMMAND ${CMAKE_COMMAND} -D MODE=message -D COMPILER=${CMAKE_CXX_COMPILER}
                               -D OPTIONS=${syntax}/plain.options -D HEADER=${syntax}/${layer}.hpp -D PROGRAM=${program}
                               -D OUTPUT=${message} -P ${script})
    list(APPEND messages ${message})
  endforeach()
endforeach()
add_custom_target(refusals COMMAND ${CMAKE_COMMAND} -D MODE=write -D MESSAGES=${folder} -P ${script} DEPENDS ${messages})
add_dependencies(docs refusals)
