# Install rules in three components (program, dev, python), the CMake package (find_package(sturm)) and Debian packages of the components.
include(CMakePackageConfigHelpers)
# Packages are made of what is built, without the tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)
install(TARGETS sturm RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS sturm_imageformats LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/sturm)
# The viewer's page without data, if it was built (scripts/viewer).
install(FILES ${PROJECT_SOURCE_DIR}/build/viewer/viewer.html DESTINATION ${CMAKE_INSTALL_DATADIR}/sturm/viewer OPTIONAL)
include(cmake/install_help.cmake)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/configs DESTINATION ${CMAKE_INSTALL_DATADIR}/sturm)
# The validation experiment names its independent numbers by a path relative to itself.
install(FILES ${PROJECT_SOURCE_DIR}/tests/reference/naked_eye_blur.json DESTINATION ${CMAKE_INSTALL_DATADIR}/sturm/tests/reference)

set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME dev)
set(sturm_libraries sturm_lensmodel sturm_io sturm_pathtrace sturm_conoid sturm_wavefront sturm_compare sturm_reports sturm_stages)
install(TARGETS ${sturm_libraries} EXPORT sturm_targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(public_headers ${PROJECT_BINARY_DIR}/generated/public)
install(CODE "execute_process(COMMAND \"${CMAKE_COMMAND}\" \"-DSOURCE=${PROJECT_SOURCE_DIR}\" \"-DOUTPUT=${public_headers}\"
  -P \"${PROJECT_SOURCE_DIR}/cmake/write_public_headers.cmake\" COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY ${public_headers}/sturm DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/sturm)
install(EXPORT sturm_targets NAMESPACE sturm:: DESTINATION ${package_folder})
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/sturm-config.cmake.in ${PROJECT_BINARY_DIR}/sturm-config.cmake
  INSTALL_DESTINATION ${package_folder})
# Semantic versions: below 1.0 a new minor version may change the library's interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/sturm-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/sturm-config.cmake ${PROJECT_BINARY_DIR}/sturm-config-version.cmake ${PROJECT_SOURCE_DIR}/cmake/opencv.cmake
  DESTINATION ${package_folder})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "Sturm's developers <sturm@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program dev)
set(CPACK_COMPONENT_DEV_DESCRIPTION "Static libraries, headers and the CMake package of Sturm")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME sturm)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libsturm-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libeigen3-dev, libtbb-dev, libembree-dev, libopenexr-dev, nlohmann-json3-dev, libvalijson-dev, libassimp-dev, libssl-dev, libpng-dev, libopencv-core-dev, libopencv-imgproc-dev")
if(STURM_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Sturm in Python")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-sturm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
endif()
include(CPack)
