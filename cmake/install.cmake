# Install rules and the CMake package (find_package(sturm)).
include(CMakePackageConfigHelpers)
set(sturm_libraries sturm_lensmodel sturm_io sturm_pathtrace sturm_conoid sturm_wavefront sturm_compare sturm_reports)
install(TARGETS sturm RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS sturm_imageformats LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/sturm)
install(TARGETS ${sturm_libraries} EXPORT sturm_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(module lensmodel io pathtrace conoid wavefront compare reports)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${module}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/sturm/${module} FILES_MATCHING PATTERN "*.h")
endforeach()
include(cmake/install_help.cmake)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs DESTINATION ${CMAKE_INSTALL_DATADIR}/sturm)
# The validation experiment names its independent numbers by a path relative to itself.
install(FILES ${PROJECT_SOURCE_DIR}/tests/reference/naked_eye_blur.json DESTINATION ${CMAKE_INSTALL_DATADIR}/sturm/tests/reference)
install(EXPORT sturm_targets NAMESPACE sturm:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/sturm)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/sturm-config.cmake.in ${PROJECT_BINARY_DIR}/sturm-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/sturm)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sturm-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sturm-config.cmake ${PROJECT_BINARY_DIR}/sturm-config-version.cmake ${PROJECT_SOURCE_DIR}/cmake/opencv.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/sturm)
