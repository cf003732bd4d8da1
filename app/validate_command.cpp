#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "io/files/readable_text.h"
#include "io/json/schema.h"
#include "io/specs/blur_field_spec.h"
#include "io/specs/ellipse_query.h"
#include "io/specs/experiment/bench_spec.h"
#include "io/specs/experiment/experiment_spec.h"
#include "io/specs/experiment/gate_spec.h"
#include "io/specs/psf_spec.h"
#include "io/specs/render_spec.h"
#include "io/specs/spectacles_spec.h"

namespace sturm {

int validate_command(const std::string& file) {
  const Json document = load_json(file);
  const std::string name = format_of(document, file);
  validate(document, name, file);
  // The readers check more than the schema can say: files that must exist, values that depend on each other.
  if (name == "ellipse")
    read_ellipse_query(document, file);
  else if (name == "blurfield")
    read_blur_field_spec(document, file);
  else if (name == "render")
    read_render_spec(document, file);
  else if (name == "psf")
    read_psf_spec(document, file);
  else if (name == "experiment")
    read_experiment(document, file);
  else if (name == "bench")
    read_bench(document, file);
  else if (name == "gates")
    require_calibrated(read_gates(document, file), file);
  else if (name == "scene")
    read_scene(document, {file, ""});
  else if (name == "eye")
    read_eye(document, {file, ""});
  else if (name == "spectacles")
    read_spectacles(document, {file, ""}, Eye{});
  std::cout << readable(file) << ": a valid " << document.at("format").get<std::string>() << "\n";
  return 0;
}

int schema_command(const std::string& name) {
  if (name.empty()) {
    for (const std::string& known : schema_names()) std::cout << known << "\n";
  } else {
    std::cout << schema_text(name);
  }
  return 0;
}

}  // namespace sturm
