#include "io/specs/blur_field_spec.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/words.h"
#include "io/specs/worn_eye_spec.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double most_voxels = 1 << 28;  // 4 GiB of them

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
  visible.sight = read_line_of_sight(value, where);
  visible.looks_per_cell = value.value("looks_per_cell", visible.looks_per_cell);
  return visible;
}

}  // namespace

BlurFieldSpec read_blur_field_spec(const Json& document, const std::string& file) {
  validate(document, "blurfield", file);
  const Source root{file, ""};
  BlurFieldSpec spec;
  WornEyeSpec read = read_worn_eye(document, root);
  spec.eye = read.worn.eye;
  spec.spectacles = std::move(read.worn.spectacles);
  spec.notes = std::move(read.notes);
  spec.input_files = std::move(read.input_files);
  read_field(document["field"], root / "field", spec);

  const Json resolved = with_defaults(document, "blurfield");
  const auto forms = resolved["forms"].get<std::vector<std::string>>();
  const auto has = [&](const char* form) { return std::find(forms.begin(), forms.end(), form) != forms.end(); };
  spec.voxels = has("voxels");
  spec.depth_analytic = has("depth_analytic");
  spec.method = read_word(resolved["method"], root / "method", field_method_words);
  if (spec.depth_analytic && spec.method != FieldMethod::ray_transfer && document.contains("forms"))
    (root / "forms").fail(document["forms"], "only \"voxels\" for the method " + compact(resolved["method"]));
  if (spec.method != FieldMethod::ray_transfer) spec.depth_analytic = false;
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
