# What the CMakeLists.txt of each layer states in one line each: its headers, its tests, its refused programs.
include(refused)

# Warnings for our own sources; -Werror at top level.
function(vectrix_warnings target)
  target_compile_options(${target} PRIVATE ${VECTRIX_WARNINGS})
endfunction()
set(VECTRIX_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                     $<$<BOOL:${VECTRIX_WERROR}>:-Werror>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND VECTRIX_WARNINGS -Wno-restrict)  # g++ 12 reports overlaps in std::string's operator+ that do not exist
endif()

# Sets the include folder of <layer> on <target>, for the source tree and for the installation.
function(vectrix_headers target layer scope)
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/${layer}/include>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${layer})
  add_library(vectrix::${layer} ALIAS ${target})
  if(VECTRIX_INSTALL)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${layer}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT ${layer}
            FILES_MATCHING PATTERN "*.hpp")
    install(TARGETS ${target} EXPORT vectrix-${layer} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${layer})
  endif()
endfunction()

# Compiles the files of a program or a library by eights, which saves common instantiations and asks a compiler for two
# gigabytes of memory. The files of tests have namespaces with their own names; in src, what the anonymous namespaces
# of a layer contain has different names. A file with options of its own is compiled alone. One file at a time:
# -DVECTRIX_FILES_TOGETHER=1.
set(VECTRIX_FILES_TOGETHER 8 CACHE STRING "How many files of a program or a library are compiled together")
mark_as_advanced(VECTRIX_FILES_TOGETHER)
function(vectrix_compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${VECTRIX_FILES_TOGETHER})
endfunction()

# The shared library vectrix_<layer> from src/**.cpp. Only names marked VECTRIX_EXPORT are visible outside.
function(vectrix_library layer)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS src/*.cpp)
  add_library(vectrix_${layer} SHARED ${sources})
  vectrix_headers(vectrix_${layer} ${layer} PUBLIC)
  set_target_properties(vectrix_${layer} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION 0.1
                                                    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  vectrix_warnings(vectrix_${layer})
  vectrix_compile_together(vectrix_${layer})
endfunction()

# A layer that cannot be built because <what> is missing: an error if the layer was requested, else it is left out.
function(vectrix_missing layer what wanted)
  string(TOUPPER ${layer} option)
  if(NOT wanted STREQUAL "AUTO")
    message(FATAL_ERROR "vectrix::${layer} needs ${what}, or -DVECTRIX_${option}=OFF")
  endif()
  message(STATUS "vectrix::${layer} needs ${what}: left out")
endfunction()

# Options of the programs of tests alone, which are half of what is compiled. g++ optimises them less than the libraries, the
# examples, accuracy and validate, which instantiate the same headers at -O2. Under the sanitizers they do not look for null
# and for wrongly aligned pointers themselves, as the libraries do: the address sanitizer stops at each use of the one, the
# processor at Eigen's use of the other.
set(VECTRIX_TEST_OPTIONS "" CACHE STRING "Options of the programs of tests alone")
separate_arguments(test_options NATIVE_COMMAND "${VECTRIX_TEST_OPTIONS}")
mark_as_advanced(VECTRIX_TEST_OPTIONS)

# tests/**_test.cpp of the current folder: one program vectrix_<layer>_tests, a test for each of its suites; files of refused
# programs: one test each.
function(vectrix_tests layer)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS tests/*_test.cpp)
  if(VECTRIX_BUILD_TESTS AND sources)
    add_executable(vectrix_${layer}_tests ${sources})
    target_link_libraries(vectrix_${layer}_tests PRIVATE ${ARGN} vectrix_testing GTest::gtest_main rapidcheck rapidcheck_gtest)
    target_include_directories(vectrix_${layer}_tests PRIVATE tests)
    target_compile_features(vectrix_${layer}_tests PRIVATE cxx_std_20)
    target_compile_definitions(vectrix_${layer}_tests PRIVATE VECTRIX_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    target_compile_options(vectrix_${layer}_tests PRIVATE ${test_options})
    vectrix_warnings(vectrix_${layer}_tests)
    if(EXISTS ${PROJECT_SOURCE_DIR}/${layer}/include/vectrix/${layer}.hpp)
      target_precompile_headers(vectrix_${layer}_tests PRIVATE <gtest/gtest.h> <rapidcheck/gtest.h> <vectrix/${layer}.hpp>
                                ${PROJECT_SOURCE_DIR}/testing/generators.hpp)
    endif()
    vectrix_compile_together(vectrix_${layer}_tests)
    set(suites ${CMAKE_CURRENT_BINARY_DIR}/vectrix_${layer}_suites.cmake)
    file(GENERATE OUTPUT ${suites} CONTENT "set(layer ${layer})
set(program \"$<TARGET_FILE:vectrix_${layer}_tests>\")
include(\"${PROJECT_SOURCE_DIR}/cmake/suites.cmake\")
")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${suites})
  endif()
  if(VECTRIX_REFUSED_TESTS)
    vectrix_refused_tests(${layer})
  endif()
endfunction()

# tests/fuzz/*.cpp of the current folder: one libFuzzer program of the library <target> and one short test each, with its seeds
# in tests/fuzz/corpus. What it finds is kept in the build folder.
function(vectrix_fuzz_tests layer target)
  if(NOT VECTRIX_FUZZ)
    return()
  endif()
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "VECTRIX_FUZZ needs clang")
  endif()
  target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  file(GLOB sources CONFIGURE_DEPENDS tests/fuzz/*.cpp)
  foreach(source IN LISTS sources)
    cmake_path(GET source STEM reader)
    set(program fuzz_${reader})
    add_executable(${program} ${source})
    target_link_libraries(${program} PRIVATE ${target})
    target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_options(${program} PRIVATE -fsanitize=fuzzer)
    target_link_options(${program} PRIVATE -fsanitize=fuzzer)
    vectrix_warnings(${program})
    set(found ${CMAKE_CURRENT_BINARY_DIR}/fuzz/${reader})
    file(MAKE_DIRECTORY ${found})
    add_test(NAME fuzz.${layer}.${reader}
             COMMAND ${program} -seed=1 -runs=5000 -max_len=1024 -timeout=10 -rss_limit_mb=1024 -verbosity=0
                     -artifact_prefix=${found}/ ${found} ${CMAKE_CURRENT_SOURCE_DIR}/tests/fuzz/corpus/${reader})
  endforeach()
endfunction()
