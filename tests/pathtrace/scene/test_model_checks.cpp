#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io/files/error.h"
#include "pathtrace/scene/collada_check.h"
#include "pathtrace/scene/ply_check.h"
#include "pathtrace/scene/scene_import.h"

namespace sturm {
namespace {

using testing::HasSubstr;

class ModelChecks : public testing::Test {
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
      std::filesystem::path(testing::TempDir()) / ("sturm_model_" + std::to_string(::getpid()));
};

TEST_F(ModelChecks, PlyHeadersAreWholeAndHonest) {
  const std::string start = "ply\nformat ascii 1.0\n", end = "end_header\n0 0 0\n";
  const std::string vertices = "comment by hand\nelement vertex 1\nproperty float x\nproperty list uchar int i\n";
  EXPECT_EQ(refusal(check_ply, start + vertices + end), "");
  EXPECT_EQ(refusal(check_ply, "ply\r\nformat ascii 1.0\r\nelement vertex 0\r\nend_header\r\n"), "");
  EXPECT_THAT(refusal(check_ply, start + vertices), HasSubstr("end_header"));
  EXPECT_THAT(refusal(check_ply, start + "element vertex 4000000000\n" + end), HasSubstr("line 3"));
  EXPECT_THAT(refusal(check_ply, start + "element 777777777777face 1\n" + end), HasSubstr("name"));
  EXPECT_THAT(refusal(check_ply, start + "element vertex 1 9\n" + end), HasSubstr("name"));
  EXPECT_THAT(refusal(check_ply, start + "element vertex -1\n" + end), HasSubstr("bytes"));
  EXPECT_THAT(refusal(check_ply, start + "property ucha5 0 0\n" + end), HasSubstr("ucha5"));
  EXPECT_THAT(refusal(check_ply, start + "0 0 1\n" + end), HasSubstr("statement"));
  EXPECT_THAT(refusal(check_ply, "obj\n" + end), HasSubstr("expected ply"));
}

TEST_F(ModelChecks, ColladaListsAreWholeNumbers) {
  EXPECT_EQ(refusal(check_collada, "<p>0 1\n2</p><float_array count=\"3\">1 2 3</float_array>"), "");
  EXPECT_THAT(refusal(check_collada, "<p>0 1,2</p>"), HasSubstr("<p>"));
  EXPECT_THAT(refusal(check_collada, "<vcount>3 x</vcount>"), HasSubstr("whole numbers"));
  EXPECT_THAT(refusal(check_collada, "<float_array count=\"4000000000\">1</float_array>"), HasSubstr("4000000000"));
  EXPECT_THAT(refusal(check_collada, "<float_array count=\"-1\">1</float_array>"), HasSubstr("count"));
}

TEST_F(ModelChecks, FacesOfNothingAreErrorsOfTheFile) {
  const auto read = [](const std::filesystem::path& file) {
    SceneSpec scene;
    scene.models.push_back({.file = file});
    build_scene(scene);
  };
  file_ += ".ply";
  // Found by made-up bytes: an assertion within Assimp ended the program.
  std::string text =
      "ply\n"
      "format ascii 1.0\n"
      "element vertex 3\n"
      "property double x\n"
      "property double y\n"
      "property double z\n"
      "property uchar red\n"
      "property uchar green\n"
      "property uchar blue\n"
      "element face 1\n"
      "property list uchar int vertex_indices\n"
      "end_header\n"
      "1 0 -2 255 0 0\n"
      "1 0 -2 0 m?5 0\n"
      "0 1 -2 055 20 \n"
      "3 0 1 2\n";
  text[text.find('?')] = '\0';
  EXPECT_THAT(refusal(read, text), HasSubstr("no vertices"));
  // A face that names vertices which are not there: Assimp would read them.
  const std::string start = text.substr(0, text.find("1 0 -2"));
  EXPECT_THAT(refusal(read, start + "1 0 -2 0 0 0\n2 0 -2 0 0 0\n2 1 -2 0 0 0\n4 0 1 2 900000\n"), HasSubstr("vertex"));
}

}  // namespace
}  // namespace sturm
