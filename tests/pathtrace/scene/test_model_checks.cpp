#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io/files/error.h"
#include "pathtrace/scene/collada_check.h"

namespace sturm {
namespace {

using ::testing::HasSubstr;

class ModelChecks : public ::testing::Test {
 protected:
  ~ModelChecks() override { std::filesystem::remove(file_); }

  /// What a check says of a file with this text; "" if it has nothing to say.
  std::string refusal(void (*check)(const std::filesystem::path&), const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    try {
      check(file_);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path file_ =
      std::filesystem::path(::testing::TempDir()) / ("sturm_model_" + std::to_string(::getpid()));
};

TEST_F(ModelChecks, ColladaListsAreWholeNumbers) {
  EXPECT_EQ(refusal(check_collada, "<p>0 1\n2</p><float_array count=\"3\">1 2 3</float_array>"), "");
  EXPECT_THAT(refusal(check_collada, "<p>0 1,2</p>"), HasSubstr("<p>"));
  EXPECT_THAT(refusal(check_collada, "<vcount>3 x</vcount>"), HasSubstr("whole numbers"));
  EXPECT_THAT(refusal(check_collada, "<float_array count=\"4000000000\">1</float_array>"), HasSubstr("4000000000"));
  EXPECT_THAT(refusal(check_collada, "<float_array count=\"-1\">1</float_array>"), HasSubstr("count"));
}

TEST_F(ModelChecks, ColladaAccessorsStayWithinTheirArrays) {
  const auto said = [&](const std::string& count, const std::string& accessor, int parameters = 2) {
    std::string text =
        "<float_array id=\"a\" count=\"" + count + "\">1 2 3 4 5 6 7 8</float_array><accessor " + accessor + ">";
    for (int k = 0; k < parameters; ++k) text += "<param name=\"S\"/>";
    return refusal(check_collada, text + "</accessor>");
  };
  EXPECT_EQ(said("8", "source=\"#a\" count=\"4\" stride=\"2\""), "");
  EXPECT_EQ(said("8", "source=\"#a\" count=\"3\" stride=\"2\" offset=\"2\""), "");
  EXPECT_EQ(said("8", "source=\"#a\" count=\"8\"", 1), "");
  EXPECT_THAT(said("0", "source=\"#a\" count=\"4\" stride=\"2\""), HasSubstr("the 0 values that its array holds"));
  EXPECT_THAT(said("8", "source=\"#a\" count=\"5\" stride=\"2\""), HasSubstr("5 times 2 values"));
  EXPECT_THAT(said("8", "source=\"#a\" count=\"4\" stride=\"2\" offset=\"1\""), HasSubstr("from 1 on"));
  EXPECT_THAT(said("8", "source=\"#b\" count=\"4\" stride=\"2\""), HasSubstr("#b"));
  EXPECT_THAT(said("8", "source=\"#a\" count=\"4\" stride=\"2\"", 3), HasSubstr("at least its 3 parameters"));
}

}  // namespace
}  // namespace sturm
