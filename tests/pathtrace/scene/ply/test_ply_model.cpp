#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cstring>
#include <ctime>
#include <numbers>

#include "pathtrace/scene/model_folder.h"
#include "pathtrace/scene/ply/ply_model.h"

namespace sturm {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3d;
using Eigen::Vector3f;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using Triangle = std::array<std::uint32_t, 3>;

const std::string three = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string one_face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string corners_and_face = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

class PlyFile : public testing::ModelFolder {
 protected:
  PlyModel read(const std::string& text) const { return read_ply(write("m.ply", text)); }
  PlyModel read_text(const std::string& rest) const { return read("ply\nformat ascii 1.0\n" + rest); }
  std::string refusal(const std::string& text) const {
    return testing::error_of([&] { read(text); });
  }
  std::string refusal_of_text(const std::string& rest) const { return refusal("ply\nformat ascii 1.0\n" + rest); }
};

/// The bytes of a number from the least to the most significant, or the other way round.
template <class T>
std::string stored(T value, bool big) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

TEST_F(PlyFile, ReadsNumbersOfEveryKindOfText) {
  const PlyModel model = read_text(three + one_face + "+1.5 -2e-1 .25\n\n 1\t0\t0  \r\n0 1e1 -0\n3 2 1 0\n");
  ASSERT_THAT(model.positions, SizeIs(3));
  EXPECT_EQ(model.positions[0], Vector3d(1.5, -0.2, 0.25));
  EXPECT_EQ(model.positions[1], Vector3d(1, 0, 0));
  EXPECT_EQ(model.positions[2], Vector3d(0, 10, 0));
  EXPECT_THAT(model.triangles, ElementsAre(Triangle{2, 1, 0}));
  EXPECT_THAT(model.normals, IsEmpty());
  EXPECT_THAT(model.texture_coordinates, IsEmpty());
  EXPECT_THAT(model.colours, IsEmpty());
  EXPECT_THAT(model.left_out, IsEmpty());
}

TEST_F(PlyFile, LinesEndInAnyWay) {
  const std::string text = "ply\nformat ascii 1.0\n" + three + one_face + corners_and_face;
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    const PlyModel model = read(other);
    EXPECT_EQ(model.positions.at(1), Vector3d(1, 0, 0));
    EXPECT_THAT(model.triangles, ElementsAre(Triangle{0, 1, 2}));
  }
  // The last line need not end.
  EXPECT_THAT(read(text.substr(0, text.size() - 1)).triangles, SizeIs(1));
}

TEST_F(PlyFile, BytesOfEitherOrderAndOfEveryType) {
  for (const bool big : {false, true})
    for (const std::string end : {"\n", "\r\n", "\r"}) {
      std::string header =
          "ply\nformat " + std::string(big ? "binary_big_endian" : "binary_little_endian") +
          " 1.0\nelement vertex 3\nproperty int8 x\nproperty uint16 y\nproperty double z\n"
          "property list ushort short unknown\nproperty short nx\nproperty uint32 ny\nproperty char "
          "nz\nelement face 2\nproperty uchar flags\n"
          "property list int32 ushort vertex_index\nproperty list uint8 float64 texcoord\nend_header\n";
      std::string bytes;
      for (const char c : header) bytes += c == '\n' ? end : std::string(1, c);
      for (int i = 0; i < 3; ++i) {
        bytes += stored<std::int8_t>(static_cast<std::int8_t>(-10 - i), big) + stored<std::uint16_t>(0x0A0D, big) +
                 stored(0.1 * i, big);
        bytes += stored<std::uint16_t>(2, big) + stored<std::int16_t>(7, big) + stored<std::int16_t>(-7, big);
        bytes +=
            stored<std::int16_t>(-300, big) + stored<std::uint32_t>(4000000000u, big) + stored<std::int8_t>(1, big);
      }
      for (int face = 0; face < 2; ++face) {
        bytes += '\x09' + stored<std::int32_t>(3, big);
        for (const int i : {2, 0, 1}) bytes += stored<std::uint16_t>(static_cast<std::uint16_t>(i), big);
        bytes += '\x06';
        for (int i = 0; i < 6; ++i) bytes += stored(0.5 * i - face, big);
      }
      const PlyModel model = read(bytes);
      ASSERT_THAT(model.positions, SizeIs(3));
      EXPECT_EQ(model.positions[2], Vector3d(-12, 2573, 0.2));  // 0x0A0D: bytes that end lines elsewhere
      EXPECT_EQ(model.normals.at(1), Vector3f(-300, 4e9f, 1));
      EXPECT_THAT(model.triangles, ElementsAre(Triangle{2, 0, 1}, Triangle{2, 0, 1}));
      ASSERT_THAT(model.corner_coordinates, SizeIs(2));
      EXPECT_EQ(model.corner_coordinates[0][1], Vector2f(1.0f, 1.5f));
      EXPECT_EQ(model.corner_coordinates[1][2], Vector2f(1.0f, 1.5f));
    }
}

TEST_F(PlyFile, PropertiesOfVerticesInAnyOrder) {
  const PlyModel model = read_text(
      "comment by hand\nobj_info none\nelement vertex 3\nproperty uchar blue\nproperty float quality\nproperty float "
      "t\n"
      "property float z\nproperty ushort red\nproperty float y\nproperty float nz\nproperty float s\nproperty int "
      "green\n"
      "property float x\nproperty float ny\nproperty float nx\n" +
      one_face + "51 9 0.25 3 65535 2 6 0.75 102 1 5 4\n0 9 0 0 0 0 1 0 0 1 0 nan\n0 9 0 0 0 1 1 1 0 0 0 0\n3 0 1 2\n");
  EXPECT_EQ(model.positions.at(0), Vector3d(1, 2, 3));
  EXPECT_EQ(model.normals.at(0), Vector3f(4, 5, 6));
  EXPECT_EQ(model.normals.at(1), Vector3f(0, 0, 0));  // it was no direction
  EXPECT_EQ(model.texture_coordinates.at(0), Vector2f(0.75f, 0.25f));
  EXPECT_EQ(model.colours.at(0), Vector3f(1.0f, 0.4f, 0.2f));
}

TEST_F(PlyFile, FloatColoursStayAsTheyAreAndAlphaIsNoted) {
  const std::string colours = "property float red\nproperty double green\nproperty float blue\nproperty uchar alpha\n";
  const auto text = [&](const std::string& alpha) {
    return three + colours + one_face + "0 0 0 0.5 1 200 255\n1 0 0 0 0 0 " + alpha + "\n0 1 0 0 0 0 255\n3 0 1 2\n";
  };
  EXPECT_EQ(read_text(text("255")).colours.at(0), Vector3f(0.5f, 1.0f, 200.0f));
  EXPECT_THAT(read_text(text("255")).left_out, IsEmpty());
  EXPECT_THAT(read_text(text("254")).left_out, ElementsAre("alpha of vertex colours"));
}

TEST_F(PlyFile, ColoursOfFacesAreNoted) {
  const PlyModel model =
      read_text(three +
                "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\n"
                "property uchar green\nproperty uchar blue\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n");
  EXPECT_THAT(model.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(model.left_out, ElementsAre("colours of faces"));
}

TEST_F(PlyFile, CommentsNameTextures) {
  const PlyModel model =
      read_text("comment TextureFile my scan.png\ncomment TextureFile b.png\ncomment made by hand\n" + three +
                "property float texture_u\nproperty float texture_v\n" + one_face +
                "0 0 0 0 1\n1 0 0 0.5 0\n0 1 0 0 0\n3 0 1 2\n");
  EXPECT_THAT(model.textures, ElementsAre("my scan.png", "b.png"));
  EXPECT_EQ(model.texture_coordinates.at(0), Vector2f(0.0f, 1.0f));
}

TEST_F(PlyFile, PolygonsBecomeTrianglesAndCoordinatesOfCornersGoWithThem) {
  // A dart with its notch at the second corner: only the diagonal from there lies inside. Then a line, then a square.
  const PlyModel model = read_text(
      "element vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 3\n"
      "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
      "0 0 0\n2 1 0\n4 0 0\n2 4 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
      "4 0 1 2 3 8 0 0 0.1 0.1 0.2 0.2 0.3 0.3\n2 0 1 4 0 0 0 0\n4 4 5 6 7 0\n");
  ASSERT_THAT(model.triangles, SizeIs(4));
  double area = 0.0;
  for (int i = 0; i < 2; ++i) {
    const auto& [a, b, c] = model.triangles[static_cast<std::size_t>(i)];
    const double z = (model.positions[b] - model.positions[a]).cross(model.positions[c] - model.positions[a]).z();
    EXPECT_GT(z, 0.0);
    area += 0.5 * z;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(model.corner_coordinates[static_cast<std::size_t>(i)][k],
                Vector2f::Constant(0.1f * static_cast<float>(model.triangles[static_cast<std::size_t>(i)][k])));
  }
  EXPECT_DOUBLE_EQ(area, 6.0);  // of the outline, 4 · 4/2 − 4 · 1/2
  EXPECT_THAT(model.triangles, ::testing::Contains(Triangle{4, 5, 6}));
  EXPECT_THAT(model.triangles, ::testing::Contains(Triangle{4, 6, 7}));
  EXPECT_THAT(model.left_out, ElementsAre(HasSubstr("texture coordinates of faces, which 1 of them")));
}

TEST_F(PlyFile, StripsTurnEverySecondTriangle) {
  const PlyModel model = read_text(
      "element vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
      "property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 4 -1 4 2 0\n");
  EXPECT_THAT(model.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}, Triangle{2, 3, 4}, Triangle{4, 2, 0}));
}

TEST_F(PlyFile, FacesMayStandFirstAndOtherElementsBetween) {
  const PlyModel model = read_text(
      "element camera 1\nproperty float focus\nproperty list uchar float matrix\nelement face 1\n"
      "property list uchar uint vertex_indices\nelement nothing 4000000000\nelement edge 2\nproperty int vertex1\n"
      "property int vertex2\n" +
      three + "end_header\n50 2 1 0\n3 0 1 2\n0 1\n1 2\n0 0 0\n1 0 0\n0 1 0\n");
  EXPECT_THAT(model.triangles, ElementsAre(Triangle{0, 1, 2}));
  EXPECT_THAT(model.left_out, ElementsAre("2 elements \"edge\""));
}

TEST_F(PlyFile, HeadersAreWholeAndHonest) {
  const std::string end = one_face + corners_and_face;
  EXPECT_THAT(refusal("obj\n" + end), AllOf(HasSubstr("m.ply:1"), HasSubstr("expected ply")));
  EXPECT_THAT(refusal(""), HasSubstr("expected ply"));
  EXPECT_THAT(refusal_of_text(three), HasSubstr("whole header"));
  EXPECT_THAT(refusal("ply\n" + three + end), HasSubstr("a line with the format"));
  EXPECT_THAT(refusal("ply\nformat ascii 2.0\n" + three + end), AllOf(HasSubstr("m.ply:2"), HasSubstr("ascii 1.0")));
  EXPECT_THAT(refusal("ply\nformat utf8 1.0\n" + three + end), HasSubstr("binary_big_endian 1.0"));
  EXPECT_THAT(refusal_of_text("element vertex 4000000000\nproperty float x\n" + end),
              AllOf(HasSubstr("\"vertex\""), HasSubstr("4000000000"), HasSubstr("room")));
  EXPECT_THAT(refusal_of_text("element vertex -1\n" + end), HasSubstr("m.ply:3"));
  EXPECT_THAT(refusal_of_text("element vertex 1 9\n" + end), HasSubstr("name and number"));
  EXPECT_THAT(refusal_of_text("element vertex 99999999999999999999\n" + end), HasSubstr("name and number"));
  EXPECT_THAT(refusal_of_text(three + three + end), HasSubstr("every element once"));
  EXPECT_THAT(refusal_of_text(three + "property float y\n" + end), HasSubstr("every property of an element once"));
  EXPECT_THAT(refusal_of_text("property float x\n" + three + end), HasSubstr("an element before"));
  EXPECT_THAT(refusal_of_text(three + "property ucha5 a\n" + end), AllOf(HasSubstr("ucha5"), HasSubstr("a type")));
  EXPECT_THAT(refusal_of_text(three + "property list float int a\n" + end), HasSubstr("whole number"));
  EXPECT_THAT(refusal_of_text(three + "0 0 1\n" + end), HasSubstr("end_header"));
  EXPECT_THAT(refusal_of_text("element vertex 1\nproperty float x\nproperty float y\n" + end),
              HasSubstr("the properties x, y and z"));
}

TEST_F(PlyFile, ElementsOfNothingTakeNoRoom) {
  const std::string binary = "ply\nformat binary_little_endian 1.0\n" + three;
  for (const std::string name : {"face", "tristrips", "edge", "nothing"})
    EXPECT_THAT(
        read(binary + "element " + name + " 18446744073709551615\nend_header\n" + std::string(36, '\0')).triangles,
        IsEmpty())
        << name;
}

TEST_F(PlyFile, TextsAreWholeAndHonest) {
  const std::string start = three + one_face;
  EXPECT_THAT(refusal_of_text(start + "0 0 0\n1 0 0\n0 1\n3 0 1 2\n"),
              AllOf(HasSubstr("m.ply:12"), HasSubstr("\"0 1\""), HasSubstr("each property")));
  EXPECT_THAT(refusal_of_text(start + "0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2\n"),
              AllOf(HasSubstr("m.ply:11"), HasSubstr("no more numbers")));
  EXPECT_THAT(refusal_of_text(start + "0 0 0\n1 0 0\n0 1 0\n          "), HasSubstr("early end"));
  EXPECT_THAT(refusal_of_text(start + "0 0 0\n1 0 0\n0 1 0,5\n3 0 1 2\n"), AllOf(HasSubstr("0,5"), HasSubstr("point")));
  EXPECT_THAT(refusal_of_text(start + "0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n"),
              AllOf(HasSubstr("m.ply:11"), HasSubstr("(1, 0, nan)"), HasSubstr("finite")));
  for (const std::string corner : {"3", "-1", "1.5", "1e30", "nan"})
    EXPECT_THAT(refusal_of_text(start + "0 0 0\n1 0 0\n0 1 0\n3 0 1 " + corner + "\n"),
                AllOf(HasSubstr("m.ply:13"), HasSubstr("from 0 to 2")))
        << corner;
  for (const std::string length : {"-1", "2.5", "4", "1e18", "nan"})
    EXPECT_THAT(refusal_of_text(start + "0 0 0\n1 0 0\n0 1 0\n" + length + " 0 1 2\n"), HasSubstr("m.ply:13"))
        << length;
  // Found by made-up bytes: an assertion within the reader before ended the program.
  EXPECT_THAT(refusal_of_text(start + "0 0 0\n1 0 0\n0 " + std::string(1, '\0') + "5 0\n3 0 1 2\n"),
              AllOf(HasSubstr("m.ply:12"), HasSubstr("\\u0000")));
}

TEST_F(PlyFile, BytesAreWholeAndHonest) {
  const std::string start = "ply\nformat binary_little_endian 1.0\n" + three +
                            "element face 1\nproperty list int int vertex_indices\nend_header\n" +
                            std::string(36, '\0');
  const auto list = [](std::initializer_list<std::int32_t> numbers) {
    std::string bytes;
    for (const std::int32_t number : numbers) bytes += stored(number, false);
    return bytes;
  };
  EXPECT_EQ(refusal(start + list({3, 0, 1, 2})), "no InputError");
  EXPECT_THAT(refusal(start + list({3, 0, 1})), HasSubstr("room"));
  EXPECT_THAT(refusal(start + list({2000000000, 0, 1})),
              AllOf(HasSubstr("a list of 2e+09 numbers"), HasSubstr("room")));
  EXPECT_THAT(refusal(start + list({-3, 0, 1, 2})), HasSubstr("room"));
  EXPECT_THAT(refusal(start + list({3, 0, 1, 3})),
              AllOf(HasSubstr("byte " + std::to_string(start.size() + 16)), HasSubstr("from 0 to 2")));
  EXPECT_THAT(refusal(start.substr(0, start.size() - 20)), HasSubstr("room"));
}

TEST_F(PlyFile, LargePolygonsThatCrossThemselvesTakeNoTime) {
  // Corners among 200 places; the time of the processor, which grows with their square.
  std::string text =
      "element vertex 200\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list int uchar vertex_indices\nend_header\n";
  std::uint32_t state = 1;
  const auto next = [&] { return (state = state * 1664525u + 1013904223u) >> 16; };
  for (int i = 0; i < 200; ++i) text += std::to_string(next()) + " " + std::to_string(next()) + " 0\n";
  text += "12000";
  for (int i = 0; i < 12000; ++i) text += " " + std::to_string(next() % 200);
  const std::clock_t start = std::clock();
  EXPECT_THAT(read_text(text + "\n").triangles, SizeIs(11998));
  EXPECT_LT(std::clock() - start, 2 * CLOCKS_PER_SEC);  // the bar of every reader
}

}  // namespace
}  // namespace sturm
