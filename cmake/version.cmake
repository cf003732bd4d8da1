# Version, commit and build description as a generated source, rewritten only when they change.
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
get_target_property(shared_options sturm_options INTERFACE_COMPILE_OPTIONS)
set(all_flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${build_type}};${shared_options}")
add_custom_target(sturm_version_stamp
  COMMAND ${CMAKE_COMMAND}
    -DOUTPUT=${PROJECT_BINARY_DIR}/generated/build_info.cpp -DSOURCE=${PROJECT_SOURCE_DIR}
    -DVERSION=${PROJECT_VERSION} "-DCOMPILER=${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}"
    "-DBUILD_TYPE=${CMAKE_BUILD_TYPE}" "-DFLAGS=${all_flags}" -DNATIVE=${STURM_NATIVE}
    -P ${PROJECT_SOURCE_DIR}/cmake/write_build_info.cmake
  BYPRODUCTS ${PROJECT_BINARY_DIR}/generated/build_info.cpp
  VERBATIM)
