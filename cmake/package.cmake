# find_package(vectrix COMPONENTS frames kinematics space dynamics simbody). Each layer has its own export set, so that a layer
# that is not installed is not found.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/vectrix)
foreach(layer IN LISTS VECTRIX_LAYERS)
  if(TARGET vectrix_${layer})
    install(EXPORT vectrix-${layer} NAMESPACE vectrix:: DESTINATION ${package} COMPONENT ${layer})
  endif()
endforeach()
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/vectrix-config.cmake.in
                              ${PROJECT_BINARY_DIR}/vectrix-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/vectrix-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT frames)
install(FILES ${PROJECT_BINARY_DIR}/vectrix-config.cmake ${PROJECT_BINARY_DIR}/vectrix-config-version.cmake
        DESTINATION ${package} COMPONENT frames)
