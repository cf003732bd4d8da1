#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtrace/scene/gltf/accessor.h"
#include "pathtrace/scene/model_folder.h"

namespace sturm {
namespace {

using ::testing::ElementsAre;

class GltfAccessor : public testing::ModelFolder {
 protected:
  /// The bytes 0x80, 0x81, 0x00, 0x7F as two elements of two numbers.
  std::vector<float> bytes_as(const std::string& type, const std::string& normalized) const {
    const std::string buffer = R"("buffers": [{"byteLength": 4, "uri": "data:;base64,gIEAfw=="}])";
    const std::string view = R"("bufferViews": [{"buffer": 0, "byteLength": 4}])";
    const std::string accessor = R"("accessors": [{"bufferView": 0, "count": 2, "type": "VEC2", "componentType": )" +
                                 type + R"(, "normalized": )" + normalized + "}]";
    const gltf::Document document(
        write("a.gltf", R"({"asset": {"version": "2.0"}, )" + buffer + ", " + view + ", " + accessor + "}"));
    return gltf::elements(document, 0, 2, 2, document.root()).values;
  }
};

// glTF 2.0, 3.11: −128 and −127 are both −1, so that 0 is 0 and 127 is 1.
TEST_F(GltfAccessor, NormalizedBytesReachFromMinusOneToOne) {
  EXPECT_THAT(bytes_as("5120", "true"), ElementsAre(-1.0f, -1.0f, 0.0f, 1.0f));
  EXPECT_THAT(bytes_as("5120", "false"), ElementsAre(-128.0f, -127.0f, 0.0f, 127.0f));
  EXPECT_THAT(bytes_as("5121", "true"), ElementsAre(128.0f / 255.0f, 129.0f / 255.0f, 0.0f, 127.0f / 255.0f));
}

// Bytes 1, 2, 3, 4; of element 2 a sparse part says 9.
TEST_F(GltfAccessor, SparsePartsReplaceTheElementsThatTheyName) {
  const gltf::Document document(write("a.gltf", R"({"asset": {"version": "2.0"},
    "buffers": [{"byteLength": 6, "uri": "data:;base64,AQIDBAIJ"}],
    "bufferViews": [{"buffer": 0, "byteLength": 4}, {"buffer": 0, "byteOffset": 4, "byteLength": 2}],
    "accessors": [{"bufferView": 0, "count": 4, "type": "SCALAR", "componentType": 5121, "sparse": {"count": 1,
      "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 1, "byteOffset": 1}}}]})"));
  EXPECT_THAT(gltf::whole_numbers(document, 0, document.root()), ElementsAre(1u, 2u, 9u, 4u));
  EXPECT_THAT(gltf::elements(document, 0, 1, 1, document.root()).values, ElementsAre(1.0f, 2.0f, 9.0f, 4.0f));
}

}  // namespace
}  // namespace sturm
