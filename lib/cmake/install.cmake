# cmake --install: the three libraries, their public headers, and the package that find_package(wavecurve) finds.
# Each library is an export set of its own, so that a user of the numerics needs neither FLINT nor libxml2.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME library)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/wavecurve)

install(TARGETS wavecurve EXPORT wavecurve-targets FILE_SET HEADERS)
install(TARGETS wavecurve_certified EXPORT wavecurve-certified-targets FILE_SET HEADERS)
install(TARGETS wavecurve_io EXPORT wavecurve-io-targets FILE_SET HEADERS)
foreach(set IN ITEMS wavecurve-targets wavecurve-certified-targets wavecurve-io-targets)
  install(EXPORT ${set} NAMESPACE wavecurve:: DESTINATION ${package_dir})
endforeach()

configure_package_config_file(cmake/wavecurve-config.cmake.in wavecurve-config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(wavecurve-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/wavecurve-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/wavecurve-config-version.cmake cmake/FindFlint.cmake
              cmake/FindPolyclipping.cmake
        DESTINATION ${package_dir})
