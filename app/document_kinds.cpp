#include "app/document_kinds.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/schema.h"
#include "io/specs/blur_field_spec.h"
#include "io/specs/ellipse_query.h"
#include "io/specs/experiment/bench_spec.h"
#include "io/specs/experiment/experiment_spec.h"
#include "io/specs/experiment/gate_spec.h"
#include "io/specs/psf_spec.h"
#include "io/specs/render_spec.h"
#include "io/specs/see_spec.h"
#include "io/specs/spectacles_spec.h"

namespace sturm {

namespace {

struct Use {
  const char *schema, *how;
};

constexpr std::array<Use, 13> uses{{{"ellipse", "sturm ellipse"},
                                    {"render", "sturm render"},
                                    {"experiment", "sturm run"},
                                    {"bench", "sturm bench"},
                                    {"blurfield", "sturm blurfield"},
                                    {"psf", "sturm psf"},
                                    {"see", "sturm see"},
                                    {"spectacles", "sturm lens, or --lens of other commands"},
                                    {"eye", "sturm see --eye, or name it as the \"eye\" of a document"},
                                    {"scene", "sturm render, with a view that names it as its \"scene\""},
                                    {"gates", "sturm gate REPORT --gates"},
                                    {"bench_report", "sturm report"},
                                    {"report", "sturm report, sturm gate or sturm compare-runs"}}};

std::string use_of(const std::string& schema) {
  for (const Use& use : uses)
    if (use.schema == schema) return "; for this one use " + std::string(use.how);
  return "; this one is an answer and no command takes it";
}

}  // namespace

void require_kind(const Json& document, const std::string& schema, const std::string& file) {
  if (schema.empty() || !document.is_object()) return;
  const auto format = document.find("format");
  if (format == document.end() || !format->is_string()) return;
  const std::vector<std::string> names = schema_names();
  for (const std::string& other : names)
    if (other != schema && *format == "sturm." + other + "/1")
      Source{file, "/format"}.fail(*format, "\"sturm." + schema + "/1\"" + use_of(other));
}

void read_as_its_format(const Json& document, const std::string& file) {
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
  else if (name == "see")
    read_see_spec(document, file);
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
}

}  // namespace sturm
