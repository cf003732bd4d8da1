#include <gmock/gmock.h>

#include "pathtrace/scene/model_folder.h"
#include "pathtrace/scene/obj/obj_model.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;
using testing::error_of;
using ::testing::HasSubstr;

class ObjReading : public testing::ModelFolder {
 protected:
  ObjModel read(const std::string& text) const { return read_obj(write("a.obj", text)); }
  std::string error(const std::string& text) const {
    return error_of([&] { read(text); });
  }
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ObjReading, PositionsAreDouble) {
  const ObjModel model = read("v 4000000.125 -0.0625 1e-3\nv +1.0 .8e-1 2.\nv 1 2 3\nf 1 2 3\n");
  EXPECT_EQ(model.positions[0], Eigen::Vector3d(4000000.125, -0.0625, 1e-3));  // a float has steps of 1/4 there
  EXPECT_EQ(model.positions[1], Eigen::Vector3d(1.0, 0.08, 2.0));
}

TEST_F(ObjReading, NumbersCountFromTheListsOfTheMoment) {
  const ObjModel model = read(square + "f -4 -3 -2\nv 5 5 5\nf -1 1 2\nf 6 1 2\nv 9 9 9\n");
  ASSERT_EQ(model.parts.size(), 1u);
  const auto& triangles = model.parts[0].triangles;
  EXPECT_EQ(triangles[0][0].position, 0u);
  EXPECT_EQ(triangles[0][2].position, 2u);
  EXPECT_EQ(triangles[1][0].position, 4u);
  EXPECT_EQ(triangles[2][0].position, 5u);  // stated behind the face
}

TEST_F(ObjReading, APolygonMayPrecedeItsCorners) {
  // A chevron whose notch is its second corner: cut so that no triangle spans the notch.
  const ObjModel model = read("f 1 2 3 4\nv -1 -1 0\nv 0 0 0\nv 1 -1 0\nv 0 1 0\n");
  ASSERT_EQ(model.parts[0].triangles.size(), 2u);
  for (const auto& triangle : model.parts[0].triangles) {
    EXPECT_TRUE(triangle[0].position == 1u || triangle[1].position == 1u || triangle[2].position == 1u);
    EXPECT_TRUE(triangle[0].position == 3u || triangle[1].position == 3u || triangle[2].position == 3u);
  }
}

TEST_F(ObjReading, PartsAreByObjectGroupMaterialAndKindOfCorner) {
  const ObjModel model =
      read(square +
           "vt 0 0\nvn 0 0 1\no box\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\nusemtl a\nf 1 3 4\ng left "
           "side\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\no other\nf 1 2 3\n");
  ASSERT_EQ(model.parts.size(), 6u);
  EXPECT_EQ(model.parts[0].triangles.size(), 2u);  // the two runs of material a
  EXPECT_EQ(model.parts[2].object, "box");
  EXPECT_EQ(model.parts[2].groups, "left side");
  EXPECT_TRUE(model.parts[3].has_texture);
  EXPECT_FALSE(model.parts[3].has_normals);
  EXPECT_TRUE(model.parts[4].has_normals);
  EXPECT_EQ(model.parts[5].object, "other");
  EXPECT_EQ(model.parts[5].groups, "");  // groups end with their object
  ASSERT_EQ(model.used_materials.size(), 2u);
  EXPECT_EQ(model.used_materials[1].name, "b");
  EXPECT_EQ(model.used_materials[1].line, 10);
}

TEST_F(ObjReading, LinesCountOnceHoweverTheyEnd) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text = "v 0 0 0|v 1 0 0|v 0 1 0||f 1 2 \\|3|f 1 2 x|";
    for (std::size_t at; (at = text.find('|')) != std::string::npos;) text.replace(at, 1, end);
    EXPECT_THAT(error(text), HasSubstr("a.obj:7: f: got \"x\"")) << end.size();
  }
}

TEST_F(ObjReading, WrongStatementsAreNamedWithTheirLine) {
  EXPECT_THAT(error(square + "f 1 2 9\n"), HasSubstr("a.obj:5: f: got 9, expected the number of a \"v\", at most 4"));
  EXPECT_THAT(error(square + "f 1 2 3\nv 0 nan 0\n"), HasSubstr("a.obj:6: v: got nan, which is not finite"));
  EXPECT_THAT(error("v 0 1e999 0\n"), HasSubstr("not finite"));
  EXPECT_THAT(error("v 1,5 0 0\n"), HasSubstr("\"1,5\""));
  EXPECT_THAT(error(square + "f 1/2/3/4 2 3\n"), HasSubstr("1/2/3/4"));
  EXPECT_THAT(error(square + "f 99999999999999999999 1 2\n"), HasSubstr("a.obj:5"));
  EXPECT_THAT(error("v 0 0 0 2\nv 0 1 0\nv 1 0 0\nf 1 2 3\n"), HasSubstr("a.obj:1: v: got a weight of 2"));
  EXPECT_EQ(error("v 0 0 0 2\n" + square + "f 2 3 4\n"), "no InputError");  // no face has that corner
}

TEST_F(ObjReading, ColoursOfSomeVerticesLeaveTheOthersWhite) {
  const ObjModel model = read("v 0 0 0\nv 1 0 0 0.25 0.5 0.75\nv 0 1 0 1 0 0 1\nv 3 3 3\nf 1 2 3\n");
  EXPECT_THAT(model.colours, ElementsAre(Eigen::Vector3f(1, 1, 1), Eigen::Vector3f(0.25f, 0.5f, 0.75f),
                                         Eigen::Vector3f(1, 0, 0), Eigen::Vector3f(1, 1, 1)));
  EXPECT_TRUE(read(square).colours.empty());
}

TEST_F(ObjReading, UnknownStatementsArePassedOver) {
  const ObjModel model =
      read("vp 1\n" + square + "vtx 1\nfx 1\nusemtlx a\nmtllibx b\nfoo\ns off\ng\nF 1 2 3\nfo 1 3 4\n");
  ASSERT_EQ(model.parts.size(), 1u);
  EXPECT_EQ(model.parts[0].triangles.size(), 2u);
  EXPECT_TRUE(model.used_materials.empty());
  EXPECT_TRUE(model.libraries.empty());
  EXPECT_TRUE(model.left_out.empty());
}

}  // namespace
}  // namespace sturm
