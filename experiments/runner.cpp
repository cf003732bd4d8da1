#include "experiments/runner.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/findings/gate_power.h"
#include "compare/findings/judged_report.h"
#include "compare/gates/gates.h"
#include "compare/studies/sin2/summary.h"
#include "experiments/bench/measurement.h"
#include "experiments/figures/figures.h"
#include "experiments/run/progress.h"
#include "experiments/run/run_folder.h"
#include "experiments/run/scene_fingerprint.h"
#include "experiments/run/sections.h"
#include "experiments/samplings/sampling_study.h"
#include "experiments/sin2_study/sin2_study.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/sha256.h"
#include "io/files/text_file.h"
#include "io/json/manifest.h"
#include "io/specs/experiment/gate_spec.h"
#include "pathtrace/scene/scene_import.h"
#include "reports/page/bench_page.h"
#include "reports/page/run_page.h"
#include "reports/plots/figure.h"
#include "reports/plots/lens_study_figures.h"
#include "reports/plots/sampling_sheet.h"
#include "reports/sections/bench/bench_figures.h"
#include "reports/sections/sin2_study/figures.h"
#include "reports/text/csv.h"
#include "reports/text/junit.h"
#include "reports/text/markdown.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

/// The scenes of an experiment, in the order of its entries.
struct LoadedScenes {
  std::vector<SceneDescription> images, agreement;
  std::optional<SceneDescription> sampling_study;

  explicit LoadedScenes(const ExperimentSpec& spec) {
    for (const ImageExperiment& image : spec.images) images.push_back(build_scene(image.scene));
    for (const AgreementCase& c : spec.agreement) agreement.push_back(build_scene(c.scene));
    if (spec.sampling_study) sampling_study = build_scene(spec.sampling_study->scene);
  }
};

/// What a finished part depends on: the resolved spec, the program itself, the scenes as they were loaded, the lens
/// files, and what a benchmark's rounds depend on.
std::string run_key(const ExperimentSpec& spec, const LoadedScenes& scenes, const std::optional<BenchKeys>& bench) {
  std::string facts = spec_hash(*spec.resolved) + sha256_of_file("/proc/self/exe");
  if (bench) facts += bench->run;
  for (const auto* list : {&scenes.images, &scenes.agreement})
    for (const SceneDescription& scene : *list) facts += scene_fingerprint(scene);
  if (scenes.sampling_study) facts += scene_fingerprint(*scenes.sampling_study);
  for (const AgreementCase& c : spec.agreement)
    for (const std::string& file : c.input_files) facts += sha256_of_file(file);
  if (spec.lens_study)
    for (const std::string& lens_file : spec.lens_study->input_files) facts += sha256_of_file(lens_file);
  if (spec.sin2_study)
    for (const std::string& table : spec.sin2_study->input_files) facts += sha256_of_file(table);
  return sha256(facts);
}

/// The parts of one run in their order, with the time that each took (also when it was taken from an interrupted run).
class Parts {
 public:
  Parts(const RunFolder& folder, bool quiet) : folder_(folder), quiet_(quiet) {}

  Json operator()(const std::string& name, const std::string& label,
                  const std::function<Json(const ProgressFunction&)>& make) {
    const RunFolder::Part part = folder_.part(name, [&] {
      Progress progress(label, 0.0, "", quiet_);
      Json value = make([&](double fraction) { progress.update(fraction); });
      progress.update(1.0);
      return Json{{"value", std::move(value)}, {"seconds", progress.seconds()}};
    });
    if (part.reused && !quiet_) std::fprintf(stderr, "%s: taken from the interrupted run\n", label.c_str());
    seconds_ = part.value.at("seconds").get<double>();
    return part.value.at("value");
  }

  double seconds() const { return seconds_; }  ///< of the last part

 private:
  const RunFolder& folder_;
  bool quiet_;
  double seconds_ = 0.0;
};

/// The accuracy study, one part per lens.
Json lens_study(const LensStudySpec& spec, Parts& parts, double& seconds) {
  Json lenses = Json::array();
  for (const StudyLens& lens : spec.lenses) {
    lenses.push_back(parts("lens_" + lens.id, "lens " + lens.id,
                           [&](const ProgressFunction& progress) { return lens_study_of(spec, lens, progress); }));
    seconds += parts.seconds();
  }
  Json field = nullptr;
  if (spec.wide_gaze) {
    field = parts("lens_field", "wide field",
                  [&](const ProgressFunction&) { return wide_gaze_study(spec, *spec.wide_gaze); });
    seconds += parts.seconds();
  }
  return assembled_lens_study(spec, lenses, field);
}

/// The study of sin², one part per group of eyes and one for the gallery.
Json sin2_study(const Sin2StudySpec& spec, std::uint64_t seed, Parts& parts, const std::filesystem::path& folder,
                double& seconds) {
  std::vector<StudyCase> cases;
  for (const StudyEyeGroup& group : spec.groups) {
    const Json rows = parts("sin2_" + group.name, "sin² " + group.name,
                            [&](const ProgressFunction& progress) { return sin2_study_rows(spec, group, progress); });
    seconds += parts.seconds();
    for (const Json& row : rows) cases.push_back(case_of(row));
  }
  Json gallery = Json::array();
  for (const Sin2GalleryView& view : spec.gallery) {
    gallery.push_back(parts("sin2_psf_" + view.id, "PSFs " + view.id,
                            [&](const ProgressFunction&) { return sin2_gallery_entry(spec, view, seed, folder); }));
    seconds += parts.seconds();
  }
  write_file_atomically(folder / "sin2_study.csv", sin2_study_csv(cases, spec));
  return summarised_sin2_study(spec, cases, gallery);
}

/// The study of pupil samplings, one part per configuration.
Json sampling_study(const SamplingStudySpec& spec, const SceneDescription& description, std::uint64_t seed,
                    const RunFolder& folder, Parts& parts, double& seconds) {
  const Scene scene(description);
  Json entries = Json::array();
  for (std::size_t i = 0; i < spec.configurations.size(); ++i) {
    const std::string& id = spec.configurations[i].id;
    for (const Json& entry : parts("sampling_" + id, "samplings " + id, [&](const ProgressFunction& progress) {
           return sampling_entries(spec, i, scene, seed, folder.path(), progress);
         }))
      entries.push_back(entry);
    seconds += parts.seconds();
  }
  return assembled_sampling_study(spec, entries);
}

/// Where pictures go.
std::vector<std::string> output_folders(const ExperimentSpec& spec) {
  std::vector<std::string> folders = {"psf", "images", "samplings", "figures"};
  if (spec.bench) folders.push_back("references");
  return folders;
}

/// A benchmark's own requirements count as one gate more.
std::vector<GateSpec> with_requirements(std::vector<GateSpec> gates, const ExperimentSpec& spec) {
  if (spec.bench && !spec.bench->requirements.empty())
    gates.push_back({"bench_requirements", "The benchmark's own requirements hold", "bench/broken_requirements",
                     GateKind::AtMost, 0.0, "", "Each has its own bound and reason in the benchmark."});
  return gates;
}

/// Writes the pictures into the run folder; the report's list of them.
Json written(const std::vector<Figure>& figures, const std::filesystem::path& folder) {
  Json list = Json::array();
  for (const Figure& figure : figures) {
    write_file_atomically(folder / figure_file(figure.id), figure.svg);
    list.push_back(figure_json(figure));
  }
  return list;
}

void append(Json& list, const Json& entries) {
  list.insert(list.end(), entries.begin(), entries.end());
}

}  // namespace

RunOutcome run_experiment(const ExperimentSpec& spec, const std::string& experiment_file, const RunOptions& options) {
  const Stopwatch watch;
  const std::string started = utc_now();
  std::vector<std::string> inputs = spec.input_files;
  if (experiment_file != "-") inputs.insert(inputs.begin(), experiment_file);
  const std::vector<GateSpec> gates =
      with_requirements(read_gates(load_json(spec.gates.string()), spec.gates.string()), spec);
  const Json baseline =
      spec.baseline && std::filesystem::exists(*spec.baseline) ? load_json(spec.baseline->string()) : Json(nullptr);

  // Everything that can be wrong with the input shows before the output folder is touched.
  const Json reference = spec.reference ? reference_agreement(*spec.reference) : Json(nullptr);
  const LoadedScenes scenes(spec);
  std::optional<BenchKeys> bench_key;
  if (spec.bench) bench_key = bench_keys(*spec.bench, options.threads);
  std::vector<Figure> figures = drawn_figures(spec.figures);

  const RunFolder folder(
      options.folder, run_key(spec, scenes, bench_key), options.resume,
      {{"report.json", "report.html", "ellipses.csv", "lens_study.csv", "sin2_study.csv", "junit.xml", "summary.md"},
       output_folders(spec)});
  Parts parts(folder, options.quiet);
  const std::vector<Mutation> mutations = mutations_named(spec.mutations);
  std::map<std::string, double> seconds;
  Json report = {{"format", "sturm.report/1"}, {"title", spec.title},     {"spec", *spec.resolved},
                 {"psfs", Json::array()},      {"images", Json::array()}, {"must_fail", Json::array()}};
  const std::string command = "sturm run " + std::filesystem::path(experiment_file).filename().string();
  Json sin2 = nullptr;
  if (spec.reference) report["reference"] = reference;
  if (spec.ellipses) {
    report["ellipses"] = parts("ellipses", "ellipses", [&](const ProgressFunction& progress) {
      return ellipse_results(*spec.ellipses, spec.seed, mutations, progress);
    });
    seconds["ellipses"] = parts.seconds();
    report["sin2"] = sin2 = sin2_findings(report["ellipses"]);
    report["must_fail"] = must_fail_checks(*spec.ellipses, report["ellipses"]);
  }
  for (const PsfExperiment& psf : spec.psfs) {
    append(report["psfs"], parts("psf_" + psf.id, "PSF " + psf.id, [&](const ProgressFunction& progress) {
             return psf_entries(psf, spec.seed, mutations, folder.path(), progress);
           }));
    seconds["psfs"] += parts.seconds();
  }
  SharedViews views(spec, scenes.images);
  for (std::size_t i = 0; i < spec.images.size(); ++i) {
    const ImageExperiment& image = spec.images[i];
    append(report["images"], parts("image_" + image.id, "image " + image.id, [&](const ProgressFunction& progress) {
             return image_entries(spec, i, scenes.images[i], views, folder.path(), progress);
           }));
    seconds["images"] += parts.seconds();
  }
  for (std::size_t i = 0; i < spec.agreement.size(); ++i) {
    const AgreementCase& c = spec.agreement[i];
    report["agreement"].push_back(
        parts("agreement_" + c.id, "agreement " + c.id, [&](const ProgressFunction& progress) {
          return agreement_entry(c, scenes.agreement[i], spec.seed, folder.path(), progress);
        }));
    seconds["agreement"] += parts.seconds();
  }
  if (spec.lens_study) {
    report["lens_study"] = lens_study(*spec.lens_study, parts, seconds["lens_study"]);
    append(report["must_fail"], lens_study_mutants(report["lens_study"]));
    for (Figure& figure : lens_study_figures(report["lens_study"])) figures.push_back(std::move(figure));
  }
  if (spec.sin2_study) {
    report["sin2_study"] = sin2_study(*spec.sin2_study, spec.seed, parts, folder.path(), seconds["sin2_study"]);
    append(report["must_fail"], sin2_study_mutants(report["sin2_study"]));
    for (Figure& figure : sin2_study_figures(report["sin2_study"], folder.path())) {
      figure.command = command;
      figures.push_back(std::move(figure));
    }
  }
  if (spec.sampling_study) {
    report["sampling_study"] = sampling_study(*spec.sampling_study, *scenes.sampling_study, spec.seed, folder, parts,
                                              seconds["sampling_study"]);
    for (Figure& figure : sampling_sheets(report["sampling_study"], folder.path()))
      figures.push_back(std::move(figure));
  }
  if (spec.bench) {
    const Stopwatch of_bench;
    report["bench"] = measured_bench(*spec.bench, *bench_key, {folder, options.threads, options.quiet});
    seconds["bench"] = of_bench.seconds();
    for (const Json& view : report["bench"]["views"])
      for (Figure& figure : bench_figures_of_experiment(view, command)) figures.push_back(std::move(figure));
  }
  if (!mutations.empty()) {
    std::vector<MutationName> names;
    for (const Mutation& mutation : mutations) names.push_back({mutation.id, mutation.what});
    report["gate_power"] = gate_power(gates, report, names, baseline);
  }
  drop_mutated(report);
  report["gates"] = evaluate_gates(gates, report, baseline.is_null() ? nullptr : &baseline);
  report["verdict"] = verdict_of(report["gates"]);
  report["verdict"]["sin2_sentence"] = sin2_sentence(sin2);
  report["verdict"]["lens_sentence"] = spec.lens_study ? lens_study_sentence(report["lens_study"]) : Json(nullptr);
  report["verdict"]["sin2_study_sentence"] =
      spec.sin2_study ? sin2_study_sentence(report["sin2_study"]) : Json(nullptr);
  report["verdict"]["bench_sentence"] = spec.bench ? bench_sentence(report["bench"]) : Json(nullptr);
  seconds["total"] = watch.seconds();
  report["provenance"] = provenance({options.threads, spec.seed, started, seconds, inputs}, *spec.resolved);

  if (!figures.empty()) report["figures"] = written(figures, folder.path());
  write_file_atomically(folder.path() / "ellipses.csv", ellipses_csv(report));
  if (spec.lens_study) write_file_atomically(folder.path() / "lens_study.csv", lens_study_csv(report["lens_study"]));
  write_file_atomically(folder.path() / "junit.xml", junit_xml(report["gates"], spec.title, seconds["total"]));
  write_file_atomically(folder.path() / "summary.md", report_markdown(report, report["gates"], report["verdict"]));
  write_file_atomically(folder.path() / "report.html", render_report_html(report, folder.path()));
  write_file_atomically(folder.path() / "report.json", report.dump(1));
  const Json& verdict = report["verdict"];
  std::vector<std::string> findings;
  for (const char* sentence : {"sin2_sentence", "lens_sentence", "sin2_study_sentence", "bench_sentence"})
    if (verdict.at(sentence).is_string()) findings.push_back(verdict.at(sentence));
  return {verdict.at("passed"), verdict.at("sentence"), std::move(findings), folder.path() / "report.html"};
}

}  // namespace sturm
