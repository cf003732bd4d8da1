#include "experiments/design_study/section.h"

#include <nlohmann/json.hpp>

#include "experiments/design_study/design_study.h"
#include "io/files/atomic_file.h"
#include "io/files/sha256.h"

namespace sturm {

namespace {

class DesignRun : public SectionRun {
 public:
  explicit DesignRun(const DesignStudySpec& spec) : spec_(spec) {}

  std::string depends_on() const override {
    std::string facts;
    for (const std::string& file : spec_.input_files) facts += sha256_of_file(file);
    return facts;
  }

  void run(const SectionPlace& place, Json& report) override {
    DesignFindings found{.conditions = conditions_of(spec_)};
    for (const StudyDesign& design : spec_.designs)
      found.designs.push_back(
          design_facts_from(place.steps("design_" + design.id, "design " + design.id,
                                        [&](const ProgressFunction&) { return to_json(facts_of(spec_, design)); })));
    for (const StudyDesign& design : spec_.designs) {
      if (!spec_.population) continue;
      for (DesignWearer& row : design_wearers_from(
               place.steps("wearers_" + design.id, "wearers of " + design.id,
                           [&](const ProgressFunction&) { return to_json(wearers_of(spec_, design)); })))
        found.wearers.push_back(std::move(row));
    }
    report["design_study"] = to_json(found);
    if (spec_.population) write_file_atomically(place.folder.path() / "design_study.csv", design_study_csv(found));
  }

  std::vector<Figure> figures(const Json& report, const RunFolder&, const std::string&) const override {
    return design_figures(spec_, *design_findings(report));
  }

  Json sentence(const Json& report) const override { return design_sentence(*design_findings(report)); }

 private:
  const DesignStudySpec& spec_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_design_study(const ExperimentSpec& spec, const RunOptions&) {
  return spec.design_study ? std::make_unique<DesignRun>(*spec.design_study) : nullptr;
}

}  // namespace sturm
