#include "experiments/lens_study/section.h"

#include <nlohmann/json.hpp>

#include "experiments/lens_study/lens_study.h"
#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "reports/plots/lens_study_figures.h"
#include "reports/text/lens_study_csv.h"

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
    LensFindings found;
    found.conditions = conditions_of(spec_);
    for (const StudyLens& lens : spec_.lenses) {
      LensPart part =
          lens_part_from(place.steps("lens_" + lens.id, "lens " + lens.id, [&](const ProgressFunction& progress) {
            return to_json(lens_study_of(spec_, lens, progress));
          }));
      found.lenses.push_back(std::move(part.lens));
      for (LensGaze& gaze : part.gazes) found.gazes.push_back(std::move(gaze));
      for (LensStudyView& view : part.views) found.views.push_back(std::move(view));
    }
    if (spec_.wide_gaze)
      found.field = lens_field_from(place.steps("lens_field", "wide field", [&](const ProgressFunction&) {
        return to_json(wide_gaze_study(spec_, *spec_.wide_gaze));
      }));
    report["lens_study"] = to_json(found);
    write_file_atomically(place.folder.path() / "lens_study.csv", lens_study_csv(found));
  }

  std::span<const OwnMutation> own_mutations() const override { return lens_study_mutations(); }

  void mutate(const std::string& mutation, Json& report) const override {
    report["lens_study"] = to_json(mutated_lens_study(*lens_findings(report), mutation));
  }

  std::vector<Figure> figures(const Json& report, const RunFolder&, const std::string&) const override {
    return lens_study_figures(*lens_findings(report));
  }

  Json sentence(const Json& report) const override { return lens_study_sentence(*lens_findings(report)); }

 private:
  const LensStudySpec& spec_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_lens_study(const ExperimentSpec& spec, const RunOptions&) {
  return spec.lens_study ? std::make_unique<LensRun>(*spec.lens_study) : nullptr;
}

}  // namespace sturm
