#include "io/specs/prediction_spec.h"

#include <nlohmann/json.hpp>

namespace sturm {

PredictionSpec read_prediction(const Json& value, const Source& where) {
  PredictionSpec spec;
  const std::string kind = value.value("prediction", "ellipses");
  spec.kind = kind == "multipass" ? PredictionKind::Multipass
              : kind == "layered" ? PredictionKind::Layered
                                  : PredictionKind::Ellipses;
  if (value.contains("passes") && spec.kind != PredictionKind::Multipass)
    (where / "passes").fail(value["passes"], "no \"passes\" unless \"prediction\" is \"multipass\"");
  if (value.contains("smooth") && spec.kind == PredictionKind::Ellipses)
    (where / "smooth").fail(value["smooth"], "no \"smooth\" for \"prediction\" \"ellipses\"");
  spec.passes = value.value("passes", spec.passes);
  spec.smooth = value.value("smooth", spec.smooth);
  spec.oversampling = value.value("oversampling", spec.oversampling);
  return spec;
}

const char* name_of(PredictionKind kind) {
  switch (kind) {
    case PredictionKind::Layered:
      return "layered";
    case PredictionKind::Multipass:
      return "multipass";
    default:
      return "ellipses";
  }
}

}  // namespace sturm
