#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "io/specs/sensor_table.h"
#include "lensmodel/eye.h"
#include "wavefront/fitting/order_choice.h"

namespace sturm {

/// A sensor's table and how a wavefront is fitted to it.
struct WavefrontQuery {
  std::string file;                 ///< of the table, for messages
  SensorTable table;                ///< slopes, spots or heights
  double pupil_radius_m = 0.0;      ///< > 0; of the disc that the modes are fitted over
  double lenslet_m = 0.0;           ///< side of a lenslet; 0 takes the gradient at its centre
  std::optional<int> radial_order;  ///< none: chosen by leaving out
  bool keep_spurious = false;       ///< ordinary least squares of everything
  bool drop_outside = false;        ///< leave out spots outside of the pupil instead of refusing them
  std::optional<double> noise;      ///< its standard deviation if it is known [rad], of heights [m]
};

/// A fitted wavefront and what became of each row of the table.
struct FittedWavefront {
  ModalFit fit;                       ///< of `points`, examiner's frame
  std::vector<SensorPoint> points;    ///< within the pupil
  std::vector<SensorPoint> outside;   ///< left out
  int radial_order = 0;               ///< highest n of the modes
  std::optional<OrderChoice> choice;  ///< if the order was chosen

  /// OSA coefficients [µm] from j = 0 on, examiner's frame.
  std::vector<double> coefficients_um() const;
};

/// Throws InputError: spots outside of the pupil, fewer spots than modes, a pupil larger than what was measured, spots
/// that do not determine the modes.
FittedWavefront fit_wavefront(const WavefrontQuery& query);

/// The sturm.wavefront_report/1 document of a fit. `mirror`: its coefficients, their covariance and the refraction are
/// those of the mirrored wavefront; places and residuals stay the sensor's.
Json wavefront_report(const WavefrontQuery& query, const FittedWavefront& fitted, bool mirror);

/// An eye's document (sturm.eye/1) with a wavefront.
struct WavefrontEye {
  std::vector<double> coefficients_um;      ///< OSA normalised, examiner's frame
  double measured_pupil_mm = 0.0;           ///< diameter that the coefficients are stated for
  double pupil_mm = 0.0;                    ///< the eye's own, not larger
  std::optional<std::string> side;          ///< "right" or "left"
  std::optional<double> wavelength_nm;      ///< that the wave is stated for
  std::string source;                       ///< where the measurement comes from, in words
  std::optional<std::string> second_order;  ///< as in the document that it is restated from
  Json others = Json::object();             ///< members of that document that are not about its wavefront
};
Json eye_document(const WavefrontEye& eye);  ///< its sturm.eye/1

/// Power and higher orders of a wavefront, for reports: M, J0, J45 and SPH/CYL/AXIS at the cornea, and root mean
/// squares.
Json refraction_json(const std::vector<double>& coefficients_um, double pupil_mm);

}  // namespace sturm
