# `cmake --install`: the two programs, and the library for find_package(rad).

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(RAD_INSTALLED rad_geom rad_scene rad_readers rad_writers rad_validate rad_repair rad_mesh rad_solve rad_bake
    rad_report)
install(TARGETS radlint radfix RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${RAD_INSTALLED} rad_build_flags EXPORT rad-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(target IN LISTS RAD_INSTALLED)
  target_include_directories(${target} PUBLIC $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/rad>)
endforeach()
foreach(layer geom scene readers writers validate repair mesh solve bake report)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${layer} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/rad
          FILES_MATCHING PATTERN "*.h" PATTERN "*.def")
endforeach()
if(TARGET rad_occt)
  install(TARGETS rad_occt LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/rad)
endif()
# The helper for IFC; `npm ci` beside package.json brings what it needs.
install(FILES ${PROJECT_SOURCE_DIR}/web/ifc/ifc_faces.mjs DESTINATION share/rad/web/ifc)
install(FILES ${PROJECT_SOURCE_DIR}/web/package.json ${PROJECT_SOURCE_DIR}/web/package-lock.json
        DESTINATION share/rad/web)
install(EXPORT rad-targets NAMESPACE rad:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rad)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/rad-config.cmake.in ${PROJECT_BINARY_DIR}/rad-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rad)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rad-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/rad-config.cmake ${PROJECT_BINARY_DIR}/rad-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rad)
