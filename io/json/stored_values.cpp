#include "io/json/stored_values.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "io/json/stored.h"
#include "io/json/values.h"

namespace sturm {

std::optional<std::uint64_t> count_at(const Json& json, std::string_view path) {
  constexpr double beyond = 0x1p64;
  const std::optional<double> number = number_at(json, path);
  return number && *number >= 0.0 && *number < beyond ? std::optional(static_cast<std::uint64_t>(*number))
                                                      : std::nullopt;
}

std::optional<double> distance_at(const Json& json, std::string_view path) {
  return text_at(json, path) == "inf" ? std::numeric_limits<double>::infinity() : number_at(json, path);
}

std::optional<RayModel> ray_model_at(const Json& json, std::string_view path) {
  return ray_model_named(text_at(json, path));
}

std::optional<Eigen::Vector2d> pair_at(const Json& json, std::string_view path) {
  const Json& list = value_at(json, path);
  const auto x = number_at(list, "0"), y = number_at(list, "1");
  return x && y ? std::optional(Eigen::Vector2d(*x, *y)) : std::nullopt;
}

std::optional<Eigen::Vector3d> triple_at(const Json& json, std::string_view path) {
  const Json& list = value_at(json, path);
  const auto x = number_at(list, "0"), y = number_at(list, "1"), z = number_at(list, "2");
  return x && y && z ? std::optional(Eigen::Vector3d(*x, *y, *z)) : std::nullopt;
}

std::optional<Eigen::Matrix2d> symmetric_at(const Json& json, std::string_view path) {
  const std::optional<Eigen::Vector3d> entries = triple_at(json, path);
  if (!entries) return std::nullopt;
  return Eigen::Matrix2d{{entries->x(), entries->y()}, {entries->y(), entries->z()}};
}

Json count_or_null(const std::optional<std::uint64_t>& count) {
  return count ? Json(*count) : Json(nullptr);
}

Json distance_or_null(const std::optional<double>& distance_m) {
  return distance_m ? distance_json(*distance_m) : Json(nullptr);
}

Json pair_or_null(const std::optional<Eigen::Vector2d>& v) {
  return v ? json_of(*v) : Json(nullptr);
}

Json triple_or_null(const std::optional<Eigen::Vector3d>& v) {
  return v ? json_of(*v) : Json(nullptr);
}

Json symmetric_or_null(const std::optional<Eigen::Matrix2d>& m) {
  return m ? symmetric_json(*m) : Json(nullptr);
}

std::string name_of(const std::optional<RayModel>& model) {
  return model ? name_of(*model) : std::string();
}

}  // namespace sturm
