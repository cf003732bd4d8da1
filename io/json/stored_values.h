#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/json/json.h"
#include "lensmodel/ray_model.h"

namespace sturm {

/// Small values of findings as a report has them, both ways. Reading (paths as in io/json/stored.h): whatever is
/// missing, null or of another kind is none, of a row of numbers also when one of them is. Writing: what is none or not
/// finite is null.

/// A count: zero or more.
std::optional<std::uint64_t> count_at(const Json& json, std::string_view path);

/// Metres, or ∞ for the word "inf".
std::optional<double> distance_at(const Json& json, std::string_view path);

std::optional<RayModel> ray_model_at(const Json& json, std::string_view path);

std::optional<Eigen::Vector2d> pair_at(const Json& json, std::string_view path);
std::optional<Eigen::Vector3d> triple_at(const Json& json, std::string_view path);

/// A symmetric matrix from [xx, xy, yy].
std::optional<Eigen::Matrix2d> symmetric_at(const Json& json, std::string_view path);

Json count_or_null(const std::optional<std::uint64_t>& count);
Json distance_or_null(const std::optional<double>& distance_m);
Json pair_or_null(const std::optional<Eigen::Vector2d>& v);
Json triple_or_null(const std::optional<Eigen::Vector3d>& v);
Json symmetric_or_null(const std::optional<Eigen::Matrix2d>& m);

/// The word for a ray model; "" where there is none.
std::string name_of(const std::optional<RayModel>& model);

}  // namespace sturm
