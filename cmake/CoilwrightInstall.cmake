include(CMakePackageConfigHelpers)
install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT coilwright-targets NAMESPACE coilwright:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/coilwright)
configure_package_config_file(cmake/coilwright-config.cmake.in coilwright-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/coilwright)
write_basic_package_version_file(coilwright-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/coilwright-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/coilwright-config-version.cmake
              cmake/FindLibCsv.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/coilwright)
