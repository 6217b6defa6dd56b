# A user's program (consumer/), configured, built and run with each way of getting the library: the installed package,
# FetchContent, add_subdirectory. SUNDIALS, ERFA and Simbody are hidden where they must not be needed.
set(work ${CMAKE_CURRENT_BINARY_DIR}/consumers)
set(hidden -D CMAKE_DISABLE_FIND_PACKAGE_SUNDIALS=ON -D CMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON -D CMAKE_DISABLE_FIND_PACKAGE_Simbody=ON)
set(libraries)
foreach(layer space dynamics simbody)
  if(TARGET vectrix_${layer})
    list(APPEND libraries ${layer})
  endif()
endforeach()

# BUILD <layer>: build and run only the program of that layer, where the configuration of the others is what is tested.
function(consumer name way components)
  cmake_parse_arguments(PARSE_ARGV 3 only "" BUILD "")
  list(JOIN components "," components)
  set(target)
  set(chosen)
  if(only_BUILD)
    set(target --build-target uses_${only_BUILD})
    set(chosen -R ^uses_${only_BUILD}$)
  endif()
  add_test(NAME package.${name}
           COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${work}/${name}
                   --build-generator ${CMAKE_GENERATOR} ${target} --build-options
                   -D CMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -D CMAKE_CXX_FLAGS=${CMAKE_CXX_FLAGS} -D CMAKE_BUILD_TYPE=None -D WAY=${way}
                   -D COMPONENTS=${components} -D SOURCE=${PROJECT_SOURCE_DIR} -D CMAKE_PREFIX_PATH=${work}/prefix
                   ${only_UNPARSED_ARGUMENTS}
                   --test-command ${CMAKE_CTEST_COMMAND} --output-on-failure --no-tests=error ${chosen})
  set_tests_properties(package.${name} PROPERTIES PROCESSORS 2 COST 100)
  if(way STREQUAL "package")
    set_tests_properties(package.${name} PROPERTIES FIXTURES_REQUIRED installed)
  endif()
endfunction()

add_test(NAME package.install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${work}/prefix)
set_tests_properties(package.install PROPERTIES FIXTURES_SETUP installed)

if(TARGET vectrix_program)
  add_test(NAME package.program COMMAND ${work}/prefix/bin/vectrix --version)
  set_tests_properties(package.program PROPERTIES FIXTURES_REQUIRED installed
                                                  PASS_REGULAR_EXPRESSION "^${PROJECT_VERSION}\n$")
  # What it writes about itself is where man, bash and zsh look for it.
  set(share ${work}/prefix/${CMAKE_INSTALL_DATADIR})
  function(installed_file name file first_words)
    add_test(NAME package.${name} COMMAND ${CMAKE_COMMAND} -E cat ${file})
    set_tests_properties(package.${name} PROPERTIES FIXTURES_REQUIRED installed PASS_REGULAR_EXPRESSION "^${first_words}")
  endfunction()
  installed_file(manual ${work}/prefix/${CMAKE_INSTALL_MANDIR}/man1/vectrix.1 "[.]TH VECTRIX 1 ")
  installed_file(scenario_manual ${work}/prefix/${CMAKE_INSTALL_MANDIR}/man5/vectrix-scenario.5 "[.]TH VECTRIX.*-SCENARIO 5 ")
  installed_file(bash_completion ${share}/bash-completion/completions/vectrix "# The completion of vectrix for bash")
  installed_file(zsh_completion ${share}/zsh/vendor-completions/_vectrix "#compdef vectrix\n")
endif()

consumer(installed package "frames;kinematics;${libraries}" ${hidden})
consumer(fetched fetch "frames;kinematics" ${hidden})
consumer(installed_headers package "frames;kinematics" ${hidden})
consumer(subdirectory_headers subdirectory "frames;kinematics" ${hidden})

# The library inside a user's project: all layers are configured, one is compiled a second time. How it is compiled is stated
# by one function for all, and consumer/ sees that no layer takes a path from the user's project.
set(compiled frames)
if(TARGET vectrix_space)
  set(compiled space)
endif()
consumer(subdirectory subdirectory "frames;kinematics;${libraries}" BUILD ${compiled})

# Without the solvers space is there, which is decided before anything is compiled. If dynamics is requested explicitly
# and its solvers are missing, the error is clear; an unknown component is not found.
consumer(space_without_solvers subdirectory "frames;space" BUILD frames -D CMAKE_DISABLE_FIND_PACKAGE_SUNDIALS=ON)
consumer(dynamics_without_solvers subdirectory "dynamics" -D CMAKE_DISABLE_FIND_PACKAGE_SUNDIALS=ON -D VECTRIX_DYNAMICS=ON)
consumer(space_without_erfa subdirectory "space" ${hidden} -D VECTRIX_SPACE=ON)
set_tests_properties(package.dynamics_without_solvers PROPERTIES PASS_REGULAR_EXPRESSION "needs vectrix::space and SUNDIALS 6.4")
set_tests_properties(package.space_without_erfa PROPERTIES PASS_REGULAR_EXPRESSION "needs ERFA")
consumer(simbody_without_simbody subdirectory "simbody" -D CMAKE_DISABLE_FIND_PACKAGE_Simbody=ON -D VECTRIX_SIMBODY=ON)
set_tests_properties(package.simbody_without_simbody PROPERTIES PASS_REGULAR_EXPRESSION "vectrix::simbody needs vectrix::dynamics and Simbody 3[.]7 [(]Debian:[ \n]+libsimbody-dev[)]")
consumer(unknown_component package "frames;thermodynamics" ${hidden})
set_tests_properties(package.unknown_component PROPERTIES PASS_REGULAR_EXPRESSION "thermodynamics is not installed")
