#include "compare/findings/pictures.h"

namespace sturm {

namespace {

template <class Value>
Value value_of(const std::map<std::string, Value>& values, const std::string& key) {
  const auto found = values.find(key);
  return found != values.end() ? found->second : Value{};
}

}  // namespace

Number PictureNoiseFloor::of(const std::string& metric) const {
  return value_of(metrics, metric);
}

PictureMetric PredictionFinding::metric(const std::string& name) const {
  return value_of(metrics, name);
}

Number PredictionFinding::seconds_of(const std::string& part) const {
  return value_of(seconds, part);
}

PartErrors PredictionFinding::whole() const {
  return parts.empty() ? PartErrors{} : parts.front();
}

std::string PredictionFinding::kind_name() const {
  return kind ? name_of(*kind, psf) + (layer_sum ? "_sum" : "") : "";
}

PredictionFinding PictureFinding::prediction() const {
  return predictions.empty() ? PredictionFinding{} : predictions.front();
}

std::string PictureFinding::model() const {
  return ray_model ? name_of(*ray_model) : "";
}

}  // namespace sturm
