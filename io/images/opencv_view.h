#pragma once
// For .cpp files that compute with OpenCV only: it brings OpenCV's headers with it.
#include <opencv2/core/mat.hpp>
#include <vector>

#include "io/images/image.h"

namespace sturm {

/// Pictures as OpenCV sees them, in their own memory: nothing is copied, so a picture must outlive its view and keep
/// its size. A view of something constant is for reading only; cv::Mat cannot say so itself.
///
/// As soon as there is a view, OpenCV computes in the thread that calls it, for the loops over threads are this
/// program's own, and with the instructions that every x86-64 machine has. So its results have the same bits for any
/// number of threads and on all of these machines.
cv::Mat view(Image& image);  ///< height × width of `channels` floats
const cv::Mat view(const Image& image);

/// The same of one channel in double: height × width values, row 0 at the top.
cv::Mat1d view(std::vector<double>& values, int width, int height);
const cv::Mat1d view(const std::vector<double>& values, int width, int height);

}  // namespace sturm
