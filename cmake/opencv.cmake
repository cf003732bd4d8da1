# The target sturm_opencv: OpenCV's core and imgproc, where Debian's packages put them. OpenCV's own package file would insist on all of its modules.
find_path(OpenCV_INCLUDE opencv2/imgproc.hpp PATH_SUFFIXES opencv4 REQUIRED)
find_library(OpenCV_core_LIBRARY opencv_core REQUIRED)
find_library(OpenCV_imgproc_LIBRARY opencv_imgproc REQUIRED)
add_library(sturm_opencv INTERFACE IMPORTED)
target_include_directories(sturm_opencv INTERFACE ${OpenCV_INCLUDE})
target_link_libraries(sturm_opencv INTERFACE ${OpenCV_imgproc_LIBRARY} ${OpenCV_core_LIBRARY})
