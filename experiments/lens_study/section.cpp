#include "experiments/lens_study/section.h"

#include <nlohmann/json.hpp>

#include "experiments/run/sections.h"
#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "reports/plots/lens_study_figures.h"
#include "reports/text/csv.h"

namespace sturm {

namespace {

class LensRun : public SectionRun {
 public:
  explicit LensRun(const LensStudySpec& spec) : spec_(spec) {}

  std::string depends_on() const override {
    std::string facts;
    for (const std::string& file : spec_.input_files) facts += sha256_of_file(file);
    return facts;
  }

  void run(const SectionPlace& place, Json& report) override {
    Json lenses = Json::array();
    for (const StudyLens& lens : spec_.lenses)
      lenses.push_back(place.steps("lens_" + lens.id, "lens " + lens.id, [&](const ProgressFunction& progress) {
        return lens_study_of(spec_, lens, progress);
      }));
    Json field = nullptr;
    if (spec_.wide_gaze)
      field = place.steps("lens_field", "wide field",
                          [&](const ProgressFunction&) { return wide_gaze_study(spec_, *spec_.wide_gaze); });
    report["lens_study"] = assembled_lens_study(spec_, lenses, field);
    append(report["must_fail"], lens_study_mutants(report["lens_study"]));
    write_file_atomically(place.folder.path() / "lens_study.csv", lens_study_csv(report["lens_study"]));
  }

  std::vector<Figure> figures(const Json& report, const RunFolder&, const std::string&) const override {
    return lens_study_figures(report.at("lens_study"));
  }

  Json sentence(const Json& report) const override { return lens_study_sentence(report.at("lens_study")); }

 private:
  const LensStudySpec& spec_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_lens_study(const ExperimentSpec& spec, const RunOptions&) {
  return spec.lens_study ? std::make_unique<LensRun>(*spec.lens_study) : nullptr;
}

}  // namespace sturm
