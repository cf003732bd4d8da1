# All third-party libraries, from Debian 12's packages (scripts/dependencies.txt).
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(embree 3.13 REQUIRED)
find_package(OpenEXR 3 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(valijson REQUIRED)
find_package(CLI11 2 REQUIRED)
find_package(assimp 5.2 REQUIRED)
find_package(OpenSSL 3 REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(sturm_httplib REQUIRED IMPORTED_TARGET cpp-httplib)  # its header must be compiled as Debian's library was
add_library(sturm_httplib INTERFACE)
target_link_libraries(sturm_httplib INTERFACE PkgConfig::sturm_httplib)
find_package(ZLIB REQUIRED)
include(cmake/opencv.cmake)

# Debian's OpenImageIO package file insists on the command-line tools; the library itself is all that is needed.
find_path(OpenImageIO_INCLUDE OpenImageIO/imageio.h REQUIRED)
find_library(OpenImageIO_LIBRARY OpenImageIO REQUIRED)
find_library(OpenImageIO_Util_LIBRARY OpenImageIO_Util REQUIRED)
add_library(sturm_openimageio INTERFACE)
target_include_directories(sturm_openimageio SYSTEM INTERFACE ${OpenImageIO_INCLUDE})
target_link_libraries(sturm_openimageio INTERFACE ${OpenImageIO_LIBRARY} ${OpenImageIO_Util_LIBRARY})
