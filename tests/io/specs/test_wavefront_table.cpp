#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io/files/error.h"
#include "io/specs/wavefront_table.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class WavefrontTable : public ::testing::Test {
 protected:
  WavefrontTable()
      : file_(std::filesystem::path(::testing::TempDir()) / ("sturm_eyes_" + std::to_string(::getpid()) + ".csv")) {}
  ~WavefrontTable() override { std::filesystem::remove(file_); }

  std::vector<std::vector<double>> read(const std::string& text) const {
    std::ofstream(file_) << text;
    return read_wavefront_table(file_);
  }
  std::string error_of(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path file_;
};

TEST_F(WavefrontTable, ColumnsAreNumbersOfCoefficients) {
  const auto eyes = read("# source\nsubject,M_D,c5,c3\n1,-2,0.5,-0.25\n2,0,1,2\n");
  ASSERT_EQ(eyes.size(), 2u);
  EXPECT_THAT(eyes[0], ElementsAre(0, 0, 0, -0.25, 0, 0.5));
  EXPECT_THAT(eyes[1], ElementsAre(0, 0, 0, 2, 0, 1));
}

TEST_F(WavefrontTable, RowsWithAMissingCoefficientAreLeftOut) {
  const auto eyes = read("c0,c1\n1,NaN\n,2\n3,4\n5\n");
  ASSERT_EQ(eyes.size(), 1u);
  EXPECT_THAT(eyes[0], ElementsAre(3, 4));
}

TEST_F(WavefrontTable, WhatIsWrongIsNamed) {
  EXPECT_THAT(error_of("subject,M_D\n1,2\n"), HasSubstr("c0, c1"));
  EXPECT_THAT(error_of("c3,c4\n1,2\n1,much\n"), HasSubstr("line 3"));
  EXPECT_THAT(error_of("c3,c4\n1,inf\n"), HasSubstr("column c4"));
  EXPECT_THAT(error_of("c3,c4\nnan,1\n"), HasSubstr("at least one measured eye"));
  EXPECT_THROW(read_wavefront_table(file_.string() + ".none"), InputError);
}

}  // namespace
}  // namespace sturm
