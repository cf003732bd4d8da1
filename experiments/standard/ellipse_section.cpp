#include "experiments/standard/ellipse_section.h"

#include <nlohmann/json.hpp>

#include "compare/findings/sin2.h"
#include "experiments/run/mutated_entries.h"
#include "experiments/standard/ellipse_findings.h"
#include "experiments/standard/sin2_findings.h"

namespace sturm {

namespace {

class EllipseRun : public SectionRun {
 public:
  EllipseRun(const EllipseExperiment& spec, std::uint64_t seed) : spec_(spec), seed_(seed) {}

  void run(const SectionPlace& place, Json& report) override {
    const Json found = place.steps("ellipses", "ellipses", [&](const ProgressFunction& progress) -> Json {
      const std::vector<TracedCase> cases = traced_cases(spec_, seed_, progress);
      return {{"ellipses", to_json(ellipse_findings(spec_, cases, place.mutations))},
              {"sin2", to_json(sin2_findings(cases))}};
    });
    cases_ = found.at("ellipses").at("cases");
    report["ellipses"] = {{"conditions", found.at("ellipses").at("conditions")}, {"cases", honest_entries(cases_)}};
    report["sin2"] = found.at("sin2");
  }

  void mutate(const std::string& mutation, Json& report) const override {
    report["ellipses"]["cases"] = mutated_entries(cases_, mutation);
  }

  Json sentence(const Json& report) const override {
    const std::optional<Sin2Findings> sin2 = read_sin2(report);
    const std::optional<std::string> text = sin2 ? sin2_sentence(*sin2) : std::nullopt;
    return text ? Json(*text) : Json(nullptr);
  }

 private:
  const EllipseExperiment& spec_;
  std::uint64_t seed_;
  Json cases_ = Json::array();  ///< with what mutations make of them
};

}  // namespace

std::unique_ptr<SectionRun> prepared_ellipses(const ExperimentSpec& spec, const RunOptions&) {
  return spec.ellipses ? std::make_unique<EllipseRun>(*spec.ellipses, spec.seed) : nullptr;
}

}  // namespace sturm
