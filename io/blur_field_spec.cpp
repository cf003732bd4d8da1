#include "io/blur_field_spec.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/error.h"
#include "io/json_vectors.h"
#include "io/schema.h"
#include "io/worn_eye_spec.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double most_voxels = 1 << 28;  // 4 GiB of them

double vergence_of(double distance_m) {
  return std::isinf(distance_m) ? 0.0 : 1.0 / distance_m;
}

void read_field(const Json& value, const Source& where, BlurFieldSpec& spec) {
  spec.hfov = radians_per_degree * value["hfov_deg"].get<double>();
  spec.vfov = radians_per_degree * value.value("vfov_deg", value["hfov_deg"].get<double>());
  if (const auto directions = value.find("directions"); directions != value.end()) {
    spec.nx = (*directions)[0].get<int>();
    spec.ny = (*directions)[1].get<int>();
  }
  spec.nz = value.value("depths", spec.nz);
  if (static_cast<double>(spec.nx) * spec.ny * spec.nz > most_voxels)
    (where / "directions").fail(value, "at most 268435456 voxels: fewer directions or depths");
  const double near = value.value("near_m", 0.25);
  const double far = value.contains("far_m") ? read_distance(value["far_m"], where / "far_m") : HUGE_VAL;
  if (!(near < far)) (where / "near_m").fail(near, "a distance below that of far_m");
  spec.near_vergence_D = vergence_of(near);
  spec.far_vergence_D = vergence_of(far);
}

VisibleSceneSpec read_visible(const Json& value, const Source& where) {
  VisibleSceneSpec visible;
  visible.scene = read_scene(value["scene"], where / "scene");
  visible.position = read_vector3(value["position_m"]);
  visible.look_at = read_vector3(value["look_at_m"]);
  visible.up = value.contains("up") ? read_vector3(value["up"]) : Eigen::Vector3d::UnitY();
  visible.looks_per_cell = value.value("looks_per_cell", visible.looks_per_cell);
  const Eigen::Vector3d forward = visible.look_at - visible.position;
  if (!(forward.norm() > 0.0)) (where / "look_at_m").fail(value["look_at_m"], "a point that is not position_m");
  if (!(forward.normalized().cross(visible.up.normalized()).norm() > 1e-9))
    (where / "look_at_m").fail(value["look_at_m"], "a line of sight that is not parallel to \"up\"");
  return visible;
}

}  // namespace

BlurFieldSpec read_blur_field_spec(const Json& document, const std::string& file) {
  validate(document, "blurfield", file);
  const Source root{file, ""};
  BlurFieldSpec spec;
  WornEyeSpec worn = read_worn_eye(document, root);
  spec.eye = worn.eye;
  spec.spectacles = std::move(worn.spectacles);
  spec.notes = std::move(worn.notes);
  spec.input_files = std::move(worn.input_files);
  read_field(document["field"], root / "field", spec);

  const Json resolved = with_defaults(document, "blurfield");
  const auto forms = resolved["forms"].get<std::vector<std::string>>();
  const auto has = [&](const char* form) { return std::find(forms.begin(), forms.end(), form) != forms.end(); };
  spec.voxels = has("voxels");
  spec.depth_analytic = has("depth_analytic");
  spec.method = resolved["method"].get<std::string>();
  if (spec.depth_analytic && spec.method != "ray_transfer" && document.contains("forms"))
    (root / "forms").fail(document["forms"], "only \"voxels\" for the method \"" + spec.method + "\"");
  if (spec.method != "ray_transfer") spec.depth_analytic = false;
  if (const Json& visible = resolved["visible"]; !visible.is_null()) {
    spec.visible = read_visible(visible, root / "visible");
    const std::vector<std::string>& files = spec.visible->scene.input_files;
    spec.input_files.insert(spec.input_files.end(), files.begin(), files.end());
  }
  spec.skip_rim = resolved["skip"]["rim"].get<bool>();
  spec.skip_symmetry = resolved["skip"]["symmetry"].get<bool>();
  spec.skip_empty_voxels = resolved["skip"]["empty_voxels"].get<bool>();
  for (std::size_t i = 0; i < resolved["layers_m"].size(); ++i)
    spec.layers_m.push_back(read_distance(resolved["layers_m"][i], root / "layers_m" / i));
  spec.resolved = std::make_shared<const Json>(resolved);
  return spec;
}

}  // namespace sturm
