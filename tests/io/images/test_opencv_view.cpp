#include <gtest/gtest.h>

#include <opencv2/core/utility.hpp>

#include "io/images/opencv_view.h"

namespace sturm {
namespace {

TEST(OpenCvView, SeesThePixelsWhereTheyAre) {
  Image image(5, 4, 3);
  image.at(3, 2)[1] = 0.5f;
  cv::Mat seen = view(image);
  EXPECT_EQ(seen.cols, 5);
  EXPECT_EQ(seen.rows, 4);
  EXPECT_EQ(seen.type(), CV_32FC3);
  EXPECT_EQ(seen.at<cv::Vec3f>(2, 3)[1], 0.5f);
  seen.at<cv::Vec3f>(1, 4)[2] = 0.25f;
  EXPECT_EQ(image.at(4, 1)[2], 0.25f);
  EXPECT_EQ(view(static_cast<const Image&>(image)).data, seen.data);
}

TEST(OpenCvView, SeesValuesRowByRow) {
  std::vector<double> values(12);
  values[1 * 4 + 3] = 2.5;
  const cv::Mat1d seen = view(values, 4, 3);
  EXPECT_EQ(seen(1, 3), 2.5);
  EXPECT_EQ(seen.data, reinterpret_cast<const unsigned char*>(values.data()));
}

TEST(OpenCvView, OpenCvLeavesThreadsAndInstructionsAlone) {
  Image image(1, 1, 1);
  view(image);
  EXPECT_EQ(cv::getNumThreads(), 1);
  EXPECT_FALSE(cv::useOptimized());
}

}  // namespace
}  // namespace sturm
