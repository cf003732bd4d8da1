#include "experiments/samplings/section.h"

#include <nlohmann/json.hpp>

#include "experiments/run/scene_fingerprint.h"
#include "experiments/samplings/sampling_study.h"
#include "pathtrace/scene/scene_import.h"
#include "reports/plots/sampling_sheet.h"

namespace sturm {

namespace {

class SamplingRun : public SectionRun {
 public:
  SamplingRun(const SamplingStudySpec& spec, std::uint64_t seed)
      : spec_(spec), seed_(seed), description_(build_scene(spec.scene)) {}

  std::string depends_on() const override { return scene_fingerprint(description_); }

  std::vector<std::string> folders() const override { return {"samplings"}; }

  void run(const SectionPlace& place, Json& report) override {
    const Scene scene(description_);
    SamplingFindings found{conditions_of(spec_), {}};
    for (std::size_t i = 0; i < spec_.configurations.size(); ++i) {
      const std::string& id = spec_.configurations[i].id;
      for (SamplingEntry& entry : sampling_entries_from(
               place.steps("sampling_" + id, "samplings " + id, [&](const ProgressFunction& progress) {
                 return to_json(sampling_entries(spec_, i, scene, seed_, place.folder.path(), progress));
               })))
        found.entries.push_back(std::move(entry));
    }
    report["sampling_study"] = to_json(found);
  }

  std::vector<Figure> figures(const Json& report, const RunFolder& folder, const std::string&) const override {
    return sampling_sheets(*sampling_findings(report), folder.path());
  }

 private:
  const SamplingStudySpec& spec_;
  std::uint64_t seed_;
  SceneDescription description_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_sampling_study(const ExperimentSpec& spec, const RunOptions&) {
  return spec.sampling_study ? std::make_unique<SamplingRun>(*spec.sampling_study, spec.seed) : nullptr;
}

}  // namespace sturm
