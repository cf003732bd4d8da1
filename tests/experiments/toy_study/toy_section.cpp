#include "experiments/toy_study/toy_section.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "experiments/toy_study/toy_findings.h"
#include "experiments/toy_study/toy_spec.h"
#include "lensmodel/units.h"
#include "stages/ray_bundle.h"

namespace sturm {

namespace {

ToyEntry traced(const ToyStudySpec& spec, double defocus_D) {
  Prescription prescription;
  prescription.sphere_D = defocus_D;
  const Eye eye = Eye::with(prescription, spec.pupil_diameter_m, RelaxedAccommodation{});
  RayBundleSpec rays;
  rays.quadrature = QuadratureSpec{.radial = 4, .azimuthal = 16};
  const MeasuredBundle bundle = measure_bundle(eye_rays_for(RayModel::thin_lens, eye, 0.0).value(), 0.0, rays, 0);
  ToyEntry entry{.defocus_D = defocus_D,
                 .expected_arcmin = arcminutes_per_radian * 0.5 * spec.pupil_diameter_m * std::abs(defocus_D)};
  // A uniform disc has the standard deviation of half its radius along each axis.
  if (bundle.angular) entry.traced_arcmin = arcminutes_per_radian * 2.0 * std::sqrt(bundle.angular->covariance(0, 0));
  return entry;
}

class ToyRun : public SectionRun {
 public:
  explicit ToyRun(ToyStudySpec spec) : spec_(std::move(spec)) {}

  void run(const SectionPlace& place, Json& report) override {
    report["toy_study"] = place.steps("toy", "toy study", [&](const ProgressFunction&) {
      ToyFindings found{.pupil_mm = 1e3 * spec_.pupil_diameter_m};
      for (const double defocus : spec_.defocus_D) found.entries.push_back(traced(spec_, defocus));
      return to_json(found);
    });
  }

  Json sentence(const Json& report) const override {
    return "The toy study traced " + std::to_string(toy_findings(report)->entries.size()) + " eyes.";
  }

 private:
  ToyStudySpec spec_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_toy_study(const ExperimentSpec& spec, const RunOptions&) {
  // A study of the program has a member of ExperimentSpec; this one finds its section in the document.
  if (!spec.resolved->contains("toy_study")) return nullptr;
  return std::make_unique<ToyRun>(read_toy_study(spec.resolved->at("toy_study"), {"experiment.json", "/toy_study"}));
}

}  // namespace sturm
