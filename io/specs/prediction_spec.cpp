#include "io/specs/prediction_spec.h"

#include <nlohmann/json.hpp>

#include "io/specs/words.h"

namespace sturm {

namespace {

/// A key that some predictions alone have.
struct OwnKey {
  const char* key;
  bool (*belongs_to)(const PredictionSpec&);
  const char* expected;  ///< elsewhere
};

constexpr OwnKey own_keys[] = {
    {"passes", [](const PredictionSpec& p) { return p.kind == PredictionKind::Multipass; },
     "no \"passes\" unless \"prediction\" is \"multipass\""},
    {"smooth", [](const PredictionSpec& p) { return p.kind != PredictionKind::Ellipses; },
     "no \"smooth\" for \"prediction\" \"ellipses\""},
    {"psf", [](const PredictionSpec& p) { return p.kind == PredictionKind::DepthPsf; },
     "no \"psf\" unless \"prediction\" is \"depth_psf\""},
    {"pupil_parts",
     [](const PredictionSpec& p) { return p.kind == PredictionKind::DepthPsf && p.psf == SeenPsf::Rays; },
     "no \"pupil_parts\" unless \"prediction\" is \"depth_psf\" with \"psf\" \"rays\""},
};

PredictionSpec kind_of(const Json& value, const Source& where) {
  PredictionSpec spec;
  spec.kind = word_or(value, "prediction", spec.kind, where, prediction_kind_words);
  spec.psf = word_or(value, "psf", spec.psf, where, seen_psf_words);
  return spec;
}

}  // namespace

PredictionSpec read_prediction(const Json& value, const Source& where) {
  PredictionSpec spec = kind_of(value, where);
  for (const OwnKey& own : own_keys)
    if (value.contains(own.key) && !own.belongs_to(spec)) (where / own.key).fail(value[own.key], own.expected);
  spec.passes = value.value("passes", spec.passes);
  spec.smooth = value.value("smooth", spec.smooth);
  spec.oversampling = value.value("oversampling", spec.oversampling);
  spec.pupil_parts = spec.psf == SeenPsf::Waves ? 1 : value.value("pupil_parts", spec.pupil_parts);
  return spec;
}

void require_pupil(const PredictionSpec& prediction, const Eye& eye, const Source& where) {
  if (prediction.kind == PredictionKind::DepthPsf && prediction.psf == SeenPsf::Waves && !(eye.pupil_radius_m > 0.0))
    (where / "pupil_diameter_mm").fail(0.0, "a pupil > 0 for \"psf\" \"waves\": a pinhole has no point spread");
}

std::vector<std::string> keys_without_meaning(const Json& method) {
  const PredictionSpec spec = kind_of(method, {});
  std::vector<std::string> keys;
  for (const OwnKey& own : own_keys)
    if (!own.belongs_to(spec)) keys.emplace_back(own.key);
  return keys;
}

}  // namespace sturm
