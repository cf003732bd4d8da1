#include "experiments/standard/ellipse_section.h"

#include <nlohmann/json.hpp>

#include "experiments/run/sections.h"

namespace sturm {

namespace {

class EllipseRun : public SectionRun {
 public:
  EllipseRun(const EllipseExperiment& spec, std::uint64_t seed) : spec_(spec), seed_(seed) {}

  void run(const SectionPlace& place, Json& report) override {
    report["ellipses"] = place.steps("ellipses", "ellipses", [&](const ProgressFunction& progress) {
      return ellipse_results(spec_, seed_, place.mutations, progress);
    });
    report["sin2"] = sin2_findings(report["ellipses"]);
    append(report["must_fail"], must_fail_checks(spec_, report["ellipses"]));
  }

  Json sentence(const Json& report) const override { return sin2_sentence(report.at("sin2")); }

 private:
  const EllipseExperiment& spec_;
  std::uint64_t seed_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_ellipses(const ExperimentSpec& spec, const RunOptions&) {
  return spec.ellipses ? std::make_unique<EllipseRun>(*spec.ellipses, spec.seed) : nullptr;
}

}  // namespace sturm
