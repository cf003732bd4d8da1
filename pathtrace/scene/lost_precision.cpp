#include "pathtrace/scene/lost_precision.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "pathtrace/scene/message_text.h"

namespace sturm {
namespace {

using Eigen::Vector3f;

float extent_of(const Mesh& mesh) {
  Vector3f lower = mesh.positions.front(), upper = lower;
  for (const Vector3f& p : mesh.positions) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  return (upper - lower).norm();
}

double mean_edge_of(const Mesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += (mesh.positions[b] - mesh.positions[a]).norm() + (mesh.positions[c] - mesh.positions[b]).norm() +
           (mesh.positions[a] - mesh.positions[c]).norm();
  return sum / (3.0 * static_cast<double>(mesh.triangles.size()));
}

}  // namespace

double largest_coordinate_of(const Mesh& mesh) {
  float largest = 0.0f;
  for (const Vector3f& p : mesh.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return largest;
}

std::string lost_precision(const Mesh& mesh, double largest) {
  if (mesh.positions.empty() || mesh.triangles.empty()) return {};
  const auto at = static_cast<float>(largest);
  const double spacing = std::nextafter(at, std::numeric_limits<float>::infinity()) - at;
  if (!(spacing > 1e-4 * extent_of(mesh)) && !(spacing > 1e-2 * mean_edge_of(mesh))) return {};
  char where[16], steps[16];
  std::snprintf(where, sizeof where, "%.3g", largest);
  std::snprintf(steps, sizeof steps, "%.2g", spacing);
  return "mesh " + in_quotes(mesh.name) + ": its positions lie at up to " + where +
         " m, where single precision has steps of " + steps + " m; its shape is known no better";
}

}  // namespace sturm
