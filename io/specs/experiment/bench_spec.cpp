#include "io/specs/experiment/bench_spec.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "io/files/error.h"
#include "io/json/named_file.h"
#include "io/json/schema.h"
#include "io/json/suggest.h"
#include "io/json/unique_ids.h"
#include "io/specs/experiment/input_files.h"
#include "io/specs/words.h"

namespace sturm {

namespace {

constexpr int smallest_side = 11;  // the window of SSIM

std::vector<std::string> ids_of(const Json& list, const Source& where) {
  require_unique_ids(list, where);
  std::vector<std::string> ids;
  for (const Json& entry : list) ids.push_back(entry["id"].get<std::string>());
  return ids;
}

void require_known(const Json& id, const std::vector<std::string>& ids, const Source& where) {
  if (std::find(ids.begin(), ids.end(), id.get<std::string>()) == ids.end())
    throw InputError(where.file, where.pointer, compact(id) + did_you_mean(id.get<std::string>(), ids), one_of(ids));
}

/// The ids that `owner` names under "views", or all of them.
std::vector<std::string> views_of(const Json& owner, const std::vector<std::string>& all, const Source& where) {
  if (!owner.contains("views")) return all;
  for (std::size_t i = 0; i < owner["views"].size(); ++i) require_known(owner["views"][i], all, where / "views" / i);
  return owner["views"].get<std::vector<std::string>>();
}

/// A render document and the file where its relative paths start.
struct ViewDocument {
  Json json;
  std::string file;
};

ViewDocument view_document(const Json& value, const Source& where) {
  if (value.is_object()) return {value, where.file};
  const std::string path = existing_document(value, where, "render", "the path of a view (sturm.render/1)").string();
  return {load_json(path), path};
}

/// Reads the view with `patches` applied; what is wrong then is told about the place of the last patch.
RenderSpec read_patched(const ViewDocument& view, const std::vector<const Json*>& patches, const Source& where) {
  Json document = view.json;
  for (const Json* patch : patches) document.merge_patch(*patch);
  try {
    RenderSpec spec = read_render_spec(document, view.file);
    if (std::min(spec.camera.width, spec.camera.height) < smallest_side)
      throw InputError(view.file, "/camera/resolution", compact(document["camera"]["resolution"]),
                       "at least 11 pixels along each side, for SSIM");
    return spec;
  } catch (const InputError& error) {
    throw InputError(where.file, where.pointer, "a view that cannot be read (" + std::string(error.what()) + ")", "");
  }
}

/// The patches of a method's sweep, in order; one that changes nothing where it has none.
std::vector<Json> sweep_of(const Json& method, const Source& where) {
  if (method.contains("sweep") && method.contains("samples_per_pixel"))
    (where / "sweep")
        .fail(method["sweep"], "no \"sweep\" beside \"samples_per_pixel\": put the samples into the sweep's patches");
  std::vector<Json> sweep;
  if (method.contains("sweep")) sweep = method["sweep"].get<std::vector<Json>>();
  if (method.contains("samples_per_pixel"))
    for (const Json& samples : method["samples_per_pixel"])
      sweep.push_back({{"method", {{"samples_per_pixel", samples}}}});
  if (sweep.empty()) sweep.push_back(Json::object());
  return sweep;
}

bool is_denoised(const Json& method) {
  return method.value("picture", "raw") == "denoised";
}

/// The leaves of a patch as "passes 64, smooth false"; the samples, which are told apart anyway, left out.
std::string label_of(const Json& patch) {
  std::string label;
  for (const auto& [key, value] : patch.items()) {
    if (key == "samples_per_pixel") continue;
    const std::string part =
        value.is_object() ? label_of(value) : key + " " + (value.is_string() ? value.get<std::string>() : value.dump());
    if (!part.empty()) label += (label.empty() ? "" : ", ") + part;
  }
  return label;
}

void add_settings(BenchView& view, const ViewDocument& document, const Json& view_patch, const Json& method,
                  const Source& where) {
  const Json patch = method.value("patch", Json::object());
  const std::vector<Json> sweep = sweep_of(method, where);
  for (const Json& step : sweep) {
    RenderSpec spec = read_patched(document, {&view_patch, &patch, &step}, where);
    if (spec.camera.width != view.reference.camera.width || spec.camera.height != view.reference.camera.height)
      throw InputError(where.file, where.pointer,
                       "a picture of another size than the reference of view \"" + view.id + "\"",
                       "the same resolution");
    if (is_denoised(method) && !spec.denoise)
      (where / "picture")
          .fail(method["picture"], "a patch with method.denoise, in every setting of view \"" + view.id + "\"");
    view.settings.push_back({method["id"].get<std::string>(), label_of(step), std::move(spec)});
  }
}

/// What is measured against: the view with the changes of the benchmark's "reference" and then its own.
RenderSpec read_reference(const ViewDocument& document, const Json& view_patch, const Json& common, const Json& own,
                          const Source& where) {
  Json reference = common;
  reference.merge_patch(own);
  if (!reference.contains("samples_per_pixel"))
    throw InputError(where.file, where.pointer, "no \"samples_per_pixel\"",
                     "the samples of this view's reference, here or in its own \"reference\"");
  const Json patch = reference.value("patch", Json::object()),
             samples = {{"method", {{"samples_per_pixel", reference["samples_per_pixel"]}}}};
  RenderSpec spec = read_patched(document, {&view_patch, &patch, &samples}, where);
  if (spec.samples_per_pixel % 2 != 0)
    (where / "samples_per_pixel")
        .fail(reference["samples_per_pixel"], "an even number: the reference is made of two halves");
  return spec;
}

void require_unbiased(const BenchMethod& method, const std::string& id, const Source& where) {
  if (method.id == id && method.denoised)
    where.fail(id, "a method whose picture is raw: a filtered one is biased and proves nothing");
}

BenchRequirement read_requirement(const Json& value, const Source& where, const std::vector<std::string>& views,
                                  const std::vector<std::string>& methods) {
  BenchRequirement r;
  r.id = value["id"].get<std::string>();
  r.title = value["title"].get<std::string>();
  r.reason = value["reason"].get<std::string>();
  r.statistic = read_word(value["statistic"], where / "statistic", bench_statistic_words);
  r.error = value["error"].get<std::string>();
  require_known(value["method"], methods, where / "method");
  r.method = value["method"].get<std::string>();
  const bool needs_baseline = r.statistic != BenchStatistic::Slope && r.statistic != BenchStatistic::Error;
  if (needs_baseline != value.contains("baseline"))
    throw InputError(where.file, where.pointer, needs_baseline ? "no \"baseline\"" : "a \"baseline\"",
                     needs_baseline ? "the method that this ratio is relative to"
                                    : "none for statistic " + compact(value["statistic"]));
  if (needs_baseline) {
    require_known(value["baseline"], methods, where / "baseline");
    r.baseline = value["baseline"].get<std::string>();
  }
  r.views = views_of(value, views, where);
  if (value.contains("at_least")) r.at_least = value["at_least"].get<double>();
  if (value.contains("at_most")) r.at_most = value["at_most"].get<double>();
  if (!r.at_least && !r.at_most)
    throw InputError(where.file, where.pointer, "no bound", "\"at_least\" or \"at_most\" or both");
  return r;
}

/// A requirement on a method in a view that it is not rendered with could never pass; one on a filtered picture would
/// prove nothing.
void require_measured(const BenchSpec& spec, const BenchRequirement& requirement, const Source& where) {
  for (const BenchMethod& method : spec.methods) {
    require_unbiased(method, requirement.method, where / "method");
    require_unbiased(method, requirement.baseline, where / "baseline");
  }
  for (const BenchView& view : spec.views) {
    if (std::find(requirement.views.begin(), requirement.views.end(), view.id) == requirement.views.end()) continue;
    for (const std::string& id : {requirement.method, requirement.baseline})
      if (!id.empty() && std::none_of(view.settings.begin(), view.settings.end(),
                                      [&](const BenchSetting& s) { return s.method == id; }))
        throw InputError(where.file, where.pointer,
                         "method \"" + id + "\" in view \"" + view.id + "\", which it is not rendered in",
                         "\"views\" that the method has");
  }
}

}  // namespace

BenchSpec read_bench(const Json& document, const std::string& file) {
  return read_bench(document, Source{file, ""});
}

BenchSpec read_bench(const Json& document, const Source& root) {
  validate(document, "bench", root);
  BenchSpec spec;
  spec.resolved = std::make_shared<const Json>([&] {
    Json resolved = with_defaults(document, "bench");
    resolved.erase("$schema");
    return resolved;
  }());
  spec.title = document["title"].get<std::string>();
  spec.seed = document.value("seed", spec.seed);
  spec.rounds = document.value("rounds", spec.rounds);
  const Json &views = document["views"], &methods = document["methods"];
  const std::vector<std::string> view_ids = ids_of(views, root / "views"),
                                 method_ids = ids_of(methods, root / "methods");
  for (const Json& method : methods)
    spec.methods.push_back({method["id"].get<std::string>(), method.value("title", ""), is_denoised(method)});
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Source where = root / "views" / i;
    const Json& value = views[i];
    BenchView view;
    view.id = view_ids[i];
    view.title = value.value("title", "");
    view.exposure = value.value("exposure", view.exposure);
    if (value.contains("max_neighbourhood_radiance"))
      view.max_neighbourhood_radiance = value["max_neighbourhood_radiance"].get<double>();
    const ViewDocument picture = view_document(value["view"], where / "view");
    const Json patch = value.value("patch", Json::object());
    view.reference = read_reference(picture, patch, document.value("reference", Json::object()),
                                    value.value("reference", Json::object()), where / "reference");
    if (value["view"].is_string()) add_files(spec.input_files, {picture.file});
    add_files(spec.input_files, view.reference.input_files);
    for (std::size_t j = 0; j < methods.size(); ++j) {
      const std::vector<std::string> wanted = views_of(methods[j], view_ids, root / "methods" / j);
      if (std::find(wanted.begin(), wanted.end(), view.id) != wanted.end())
        add_settings(view, picture, patch, methods[j], root / "methods" / j);
    }
    if (view.settings.empty()) (where / "id").fail(value["id"], "a view that at least one method is rendered in");
    for (const BenchSetting& setting : view.settings) add_files(spec.input_files, setting.render.input_files);
    spec.views.push_back(std::move(view));
  }
  for (const Json& level : document.value("levels", Json::array()))
    spec.levels.push_back({level["error"].get<std::string>(), level["level"].get<double>()});
  const Json require = document.value("require", Json::array());
  require_unique_ids(require, root / "require");
  for (std::size_t i = 0; i < require.size(); ++i) {
    spec.requirements.push_back(read_requirement(require[i], root / "require" / i, view_ids, method_ids));
    require_measured(spec, spec.requirements.back(), root / "require" / i);
  }
  return spec;
}

}  // namespace sturm
