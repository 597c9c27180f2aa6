# Installs the program, the libraries and the package that find_package(nearwall) finds.
include(CMakePackageConfigHelpers)
get_property(modules GLOBAL PROPERTY NEARWALL_MODULES)

add_library(nearwall_nearwall INTERFACE)
add_library(nearwall::nearwall ALIAS nearwall_nearwall)
set_target_properties(nearwall_nearwall PROPERTIES EXPORT_NAME nearwall)
target_link_libraries(nearwall_nearwall INTERFACE ${modules})

install(TARGETS ${modules} nearwall_nearwall EXPORT nearwallTargets FILE_SET HEADERS)
install(TARGETS nearwall)
install(EXPORT nearwallTargets NAMESPACE nearwall:: DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/nearwall")
configure_package_config_file(cmake/nearwallConfig.cmake.in "${PROJECT_BINARY_DIR}/nearwallConfig.cmake"
                              INSTALL_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/nearwall")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/nearwallConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/nearwallConfig.cmake" "${PROJECT_BINARY_DIR}/nearwallConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindCGNS.cmake"
        DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/nearwall")
