#include "io/specs/prediction_spec.h"

#include <nlohmann/json.hpp>

#include "io/specs/words.h"

namespace sturm {

PredictionSpec read_prediction(const Json& value, const Source& where) {
  PredictionSpec spec;
  spec.kind = word_or(value, "prediction", spec.kind, where, prediction_kind_words);
  if (value.contains("passes") && spec.kind != PredictionKind::Multipass)
    (where / "passes").fail(value["passes"], "no \"passes\" unless \"prediction\" is \"multipass\"");
  if (value.contains("smooth") && spec.kind == PredictionKind::Ellipses)
    (where / "smooth").fail(value["smooth"], "no \"smooth\" for \"prediction\" \"ellipses\"");
  spec.passes = value.value("passes", spec.passes);
  spec.smooth = value.value("smooth", spec.smooth);
  spec.oversampling = value.value("oversampling", spec.oversampling);
  return spec;
}

}  // namespace sturm
