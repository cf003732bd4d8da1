#include <gmock/gmock.h>

#include "pathtrace/scene/model_folder.h"
#include "pathtrace/scene/obj/mtl_texture.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class MtlTextures : public testing::ModelFolder {
 protected:
  MtlTextures() {
    for (const char* name : {"t.png", "my pic.png", "1 a.png", "2.png", "-o.png", "sub/Deep.PNG"}) write(name, "");
  }
  MtlTexture read(const std::string& text) const { return read_mtl_texture(text, NamedFiles({folder_})); }
  std::string file(const std::string& text) const {
    const MtlTexture texture = read(text);
    return texture.found ? std::filesystem::relative(texture.found->file, folder_).string() : "none";
  }
};

TEST_F(MtlTextures, ShortFormsOfOptions) {
  const MtlTexture two = read("-s 2 3 -o .5 t.png");
  EXPECT_EQ(two.scale, Eigen::Vector2f(2, 3));
  EXPECT_EQ(two.offset, Eigen::Vector2f(0.5f, 0));
  EXPECT_EQ(two.name, "t.png");
  EXPECT_EQ(read("-s 2 t.png").scale, Eigen::Vector2f(2, 1));
  EXPECT_EQ(read("-s 2 3 4 t.png").scale, Eigen::Vector2f(2, 3));
  EXPECT_EQ(read("t.png -s 2 3 4").scale, Eigen::Vector2f(2, 3));
  EXPECT_EQ(read("my pic.png -clamp on").clamped, true);
  EXPECT_EQ(read("-clamp off my pic.png").clamped, false);
  EXPECT_EQ(read("t.png").clamped, std::nullopt);
  EXPECT_EQ(read("-imfchan M t.png").channel, 'm');
}

TEST_F(MtlTextures, NumbersBelongToNamesWhereOnlyThenTheFileExists) {
  EXPECT_EQ(file("-s 2 3 1 a.png"), "1 a.png");
  EXPECT_EQ(read("-s 2 3 1 a.png").scale, Eigen::Vector2f(2, 3));
  EXPECT_EQ(file("-s 2 2.png"), "2.png");
  EXPECT_EQ(file("-o.png"), "-o.png");
  EXPECT_EQ(file("-bm 0.5 -o.png"), "-o.png");
}

TEST_F(MtlTextures, NamesAsSeveralSystemsWriteThem) {
  EXPECT_EQ(file("sub\\Deep.PNG"), "sub/Deep.PNG");
  EXPECT_EQ(file("SUB/deep.png"), "sub/Deep.PNG");
  EXPECT_EQ(file("\"my pic.png\""), "my pic.png");
  EXPECT_EQ(file("D:\\work\\t.png"), "t.png");
  EXPECT_TRUE(read("D:\\work\\t.png").found->elsewhere);
  EXPECT_FALSE(read("T.png").found->elsewhere);
  EXPECT_EQ(file("t.png # the first"), "t.png");
  EXPECT_EQ(file("gone.png"), "none");
  EXPECT_EQ(file(""), "none");
  EXPECT_EQ(file("."), "none");
}

TEST_F(MtlTextures, OptionsThatChangeThePictureAreListed) {
  EXPECT_THAT(read("-mm 0.1 1 -bm 2 -t 1 -texres 256 -boost 3 -cc on -blendu off t.png").left_out,
              ElementsAre("-mm", "-bm", "-t", "-texres", "-boost", "-cc", "-blendu"));
  EXPECT_THAT(read("-mm 0 1 -t 0 0 0 -cc off -blendu on -blendv on -s 2 -o 1 -clamp on t.png").left_out, IsEmpty());
}

TEST_F(MtlTextures, ManyOptionsTakeNoTime) {
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "-s 1 1 1 ";
  EXPECT_EQ(file(text + "gone.png"), "none");
}

}  // namespace
}  // namespace sturm
