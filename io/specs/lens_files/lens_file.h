#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/specs/free_form_fit.h"
#include "io/specs/prescription_notation.h"
#include "lensmodel/prescription.h"
#include "lensmodel/spectacles.h"

namespace sturm {

/// What a document says about a lens that it takes out of a file of the trade.
struct LensFileRequest {
  std::string file;                                                        ///< absolute path
  std::optional<EyeSide> eye;                                              ///< of a job for both eyes
  std::optional<double> diameter_m, refractive_index, center_thickness_m;  ///< in place of those of the file
};

/// A spectacle lens out of such a file; its vertex distance and mounting are the document's.
struct LensFile {
  Spectacles lens;
  std::optional<Prescription> made_for;               ///< its power and prism, if the file states them
  double prism_cm_per_m = 0.0, prism_base_deg = 0.0;  ///< that the back is still to be wedged for
  std::vector<FreeFormFit> fits;
  std::vector<std::string> notes;  ///< what of the file does not count, and what was assumed
};

/// Whether a file's name says that it is a lens of the trade: .oma, .vca, .dcs, .lds, .lms, .sdf or .zmx, in either
/// case.
bool is_lens_file(std::string_view name);

/// The note of a lens whose file does not have the record that states its diameter.
std::string assumed_diameter(const std::string& record, double diameter_m);

/// Reads such a file: Zemax for .zmx, else the Data Communication Standard. Throws InputError.
LensFile read_lens_file(const LensFileRequest& request);

}  // namespace sturm
