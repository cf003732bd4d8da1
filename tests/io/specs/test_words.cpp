// What the schemas accept and what the readers know are the same words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/camera_spec.h"
#include "io/specs/ellipse_query.h"
#include "io/specs/experiment/bench_spec.h"
#include "io/specs/prediction_spec.h"
#include "io/specs/psf_spec.h"
#include "io/specs/pupil_sampling_spec.h"
#include "io/specs/ray_bundle_spec.h"
#include "io/specs/scene_spec.h"
#include "io/specs/words.h"
#include "lensmodel/field_method.h"
#include "lensmodel/lens_status.h"
#include "lensmodel/ray_model.h"
#include "lensmodel/zernike_order.h"
#include "lensmodel/zernike_wave.h"

namespace sturm {
namespace {

using ::testing::Contains;
using ::testing::ElementsAreArray;
using ::testing::HasSubstr;

struct Table {
  const char* schema;
  const char* pointer;  ///< of the place whose "enum" lists the words
  std::vector<std::string> words;
  std::set<int> values;
};

template <class Enum, std::size_t count>
Table table(const char* schema, const char* pointer, const Words<Enum, count>& words) {
  Table t{schema, pointer, words.all(), {}};
  for (const auto& entry : words.entries) t.values.insert(static_cast<int>(entry.value));
  return t;
}

std::vector<std::string> accepted(const char* schema, const std::string& pointer) {
  return schema_document(schema).at(Json::json_pointer(pointer + "/enum")).get<std::vector<std::string>>();
}

TEST(Words, AreThoseOfTheSchemas) {
  const Table tables[] = {
      table("ellipse", "/definitions/ray_model", ray_model_words),
      table("ellipse", "/definitions/sequence", sequence_words),
      table("ellipse", "/definitions/sampling", pupil_sampling_words),
      table("render", "/definitions/camera/properties/projection", projection_words),
      table("render", "/definitions/camera/properties/gaze", gaze_words),
      table("scene", "/properties/models/items/properties/texture_encoding", texture_encoding_words),
      table("scene", "/properties/models/items/properties/texture_filter", texture_filter_words),
      table("scene", "/properties/models/items/properties/texture_wrap", texture_wrap_words),
      table("blurfield", "/properties/method", field_method_words),
      table("render", "/definitions/prediction", prediction_kind_words),
      table("report", "/definitions/agreement/properties/predictions/items/properties/kind", prediction_kind_words),
      table("render", "/definitions/seen_psf", seen_psf_words),
      table("eye", "/definitions/wavefront/properties/second_order", second_order_words),
      table("eye", "/definitions/wavefront/properties/order", zernike_order_words),
      table("psf", "/properties/models/items", psf_model_words),
      table("bench", "/properties/require/items/properties/statistic", bench_statistic_words)};
  for (const Table& t : tables) {
    EXPECT_THAT(t.words, ElementsAreArray(accepted(t.schema, t.pointer))) << t.schema << t.pointer;
    EXPECT_EQ(t.values.size(), t.words.size()) << t.schema << t.pointer << ": a value has two words";
    EXPECT_EQ(*t.values.rbegin(), static_cast<int>(t.words.size()) - 1) << t.schema << t.pointer << ": one has none";
  }
}

TEST(Words, MethodsOfEllipsesAreConoidsAndRayModels) {
  std::vector<std::string> names;
  for (const auto& entry : conoid_method_words.entries) names.push_back(name_of(entry.value));
  for (const auto& entry : ray_model_words.entries) names.push_back(name_of(EllipseMethod(entry.value)));
  EXPECT_THAT(names, ElementsAreArray(accepted("ellipse", "/definitions/method")));
}

TEST(Words, OfALensAreAmongThoseOfTheResults) {
  for (const auto& [schema, pointer] : {std::pair("ellipse_result", "/properties/results/items/properties/status"),
                                        std::pair("lens_report", "/properties/gazes/items/properties/status")})
    for (const std::string& word : lens_status_words.all()) EXPECT_THAT(accepted(schema, pointer), Contains(word));
}

TEST(Words, AWordThatIsNoneOfThemIsRefusedWithItsPlace) {
  try {
    read_words(Json{"pinhole", "sin2"}, Source{"x.json", "/ray_models"}, ray_model_words);
    ADD_FAILURE() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/ray_models/1: got \"sin2\""));
    EXPECT_THAT(error.what(), HasSubstr("\"pinhole\", \"thin_lens\""));
  }
}

TEST(Words, AnAbsentMemberIsWhatItIsOtherwise) {
  const Source where{"x.json", ""};
  EXPECT_EQ(word_or(Json::object(), "sequence", Sequence::Halton, where, sequence_words), Sequence::Halton);
  EXPECT_EQ(word_or(Json{{"sequence", "independent"}}, "sequence", Sequence::Halton, where, sequence_words),
            Sequence::Independent);
}

}  // namespace
}  // namespace sturm
