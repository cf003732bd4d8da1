#include "pathtrace/guide/view_cases.h"

#include <nlohmann/json.hpp>

#include "io/specs/spectacles_spec.h"
#include "support/source_folder.h"
#include "support/units.h"

namespace sturm::testing {
namespace {

Spectacles lens_file(const std::string& name) {
  const std::string file = STURM_SOURCE_DIR "/configs/lenses/" + name + ".json";
  return *read_lens_alone(load_json(file), {file, ""}).lens;
}

/// 12 mm below the fitting cross: the eye looks through the near zone, 4 mm from the corridor, where power and cylinder
/// change.
Spectacles progressive_off_axis() {
  Spectacles lens = lens_file("progressive_regular");
  lens.mounting = Mounting({4 * mm, 12 * mm}, 0.0, 0.0);
  return lens;
}

/// The rim's shadow cuts the pupil of 6 mm.
Spectacles narrow(Spectacles lens) {
  lens.diameter_m = 5 * mm;
  return lens;
}

/// A myope of 4√3·3.3 µm/a² = 2.54 D with 0.35 µm of coma over 6 mm: of a light at 1 m, beyond 0.77 of the radius the
/// curvature that makes the blur, 2.54 D − 1 D − 18√8·0.35 µm·r/a³ = 1.54 D − 1.98 D r/a, has changed its sign: two
/// pupil points see the same light.
Eye folded_eye() {
  std::vector<double> coefficients(13, 0.0);
  coefficients[4] = 3.3e-6;
  coefficients[7] = 0.35e-6;
  coefficients[9] = -0.08e-6;
  coefficients[12] = 0.05e-6;
  return Eye::with(ZernikeWave::from_examiner(coefficients, 3 * mm), SecondOrder::LeastSquares, {}, 6 * mm);
}

}  // namespace

CameraPose view_pose(double field) {
  CameraPose p;
  p.vertical_field = field;
  p.width = p.height = view_size;
  return p;
}

Eye view_eye(const Prescription& rx, const Accommodation& accommodation) {
  return Eye::with(rx, 6 * mm, accommodation);
}

// Made when they are first asked for: a lens takes 50 ms, and every test is a process of its own.
const ViewCase& toric() {
  static const ViewCase made{"toric lens", view_eye({-3.0, -4.5, 65.0}), RayModel::power_matrix,
                             lens_file("oblique_toric_p195")};
  return made;
}

const ViewCase& progressive() {
  static const ViewCase made{"progressive lens off its axis",
                             view_eye({-3.0}),
                             RayModel::power_matrix,
                             progressive_off_axis(),
                             Gaze::Camera,
                             {},
                             0.0,
                             0.3 * mm,
                             0.6};
  return made;
}

const ViewCase& focal_line() {
  static const ViewCase made{
      "focal line at 0.4 m", view_eye({-2.5, 4.0, 60.0}), RayModel::power_matrix, {}, Gaze::Foveal};
  return made;
}

const ViewCase& rim_cut() {
  static const ViewCase made{"pupil cut by the rim", view_eye({-3.0, -4.5, 65.0}), RayModel::power_matrix,
                             narrow(lens_file("oblique_toric_p195"))};
  return made;
}

const ViewCase& folded() {
  static const ViewCase made{"folded wavefront", folded_eye(), RayModel::zernike, {}, Gaze::Camera, {}, 0.0, 1.0 * mm};
  return made;
}

// Weights and densities of a pupil move light within its blur: the sum over the picture cannot see them.
const ViewCase& weighted_polar() {
  static const ViewCase made{"weighted polar pupil", view_eye({-3.0, -1.0, 30.0}),         RayModel::power_matrix, {},
                             Gaze::Camera,           {PupilSampling::UniformPolarWeighted}};
  return made;
}

const ViewCase& raw_polar() {
  static const ViewCase made{"polar pupil", view_eye({-3.0, -1.0, 30.0}), RayModel::power_matrix, {},
                             Gaze::Camera,  {PupilSampling::UniformPolar}};
  return made;
}

std::vector<ViewCase> view_cases() {
  return {toric(),
          progressive(),
          focal_line(),
          rim_cut(),
          {"folded wavefront behind a lens, Stiles-Crawford",
           folded_eye(),
           RayModel::zernike,
           lens_file("oblique_astigmat"),
           Gaze::Camera,
           {},
           1.04},
          {"turning eye that accommodates behind a lens", view_eye({-3.0, -4.5, 65.0}, BestAccommodation{2.0}),
           RayModel::power_matrix, lens_file("oblique_toric_p195"), Gaze::Foveal},
          {"polar pupil",
           view_eye({-1.0, -3.0, 30.0}),
           RayModel::power_matrix,
           {},
           Gaze::Camera,
           {PupilSampling::UniformPolar},
           1.04},
          {"weighted polar pupil, sin² rays",
           view_eye({-1.0, -3.0, 30.0}),
           RayModel::sin2_radial,
           {},
           Gaze::Camera,
           {PupilSampling::UniformPolarWeighted}}};
}

}  // namespace sturm::testing
