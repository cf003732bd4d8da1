#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/json/json.h"
#include "lensmodel/chromatic_eye.h"
#include "lensmodel/eye.h"
#include "lensmodel/words.h"

namespace sturm {

/// How a point spread is computed.
enum class PsfModel { Rays, Waves };

/// Their words in documents.
inline constexpr Words<PsfModel, 2> psf_model_words{{{PsfModel::Rays, "rays"}, {PsfModel::Waves, "waves"}}};

/// A light with the name that results have for it.
struct NamedLight {
  std::string id;  ///< as the document has it, else "555nm", "wavelengths" or "luminance"
  Light light;     ///< weights sum to 1
};

/// A point source before the eye.
struct PsfTarget {
  std::optional<double> distance_m;  ///< none where the vergence error was given itself
  double accommodation_D = 0.0;      ///< A of the eye for this target [D], ≥ 0
  double vergence_D = 0.0;           ///< the error V that is added to the wave of the relaxed eye
};

/// A validated document of format sturm.psf/1.
struct PsfSpec {
  Eye eye;                         ///< its pupil and Stiles–Crawford effect are the document's where it states them
  double in_focus_nm = 555.0;      ///< wavelength that the eye's wave is stated for [nm]
  std::vector<PsfModel> models;    ///< how each spread is computed
  std::vector<NamedLight> lights;  ///< at least one
  std::vector<PsfTarget> targets;  ///< at least one
  bool examiner_frame = false;     ///< all directions and pictures in the examiner's frame, else the wearer's
  std::vector<double> frequencies_cpd, directions_deg, energy_shares;  ///< of the MTF [cycles/°] and [°]; in (0, 1)
  std::size_t ray_count = 0;                                           ///< of a model "rays"
  std::optional<int> wave_grid;                 ///< rows of the transform; none: as the slopes ask for
  std::vector<double> cells_arcmin;             ///< sides of the cells in which rays and waves are compared
  double field_arcmin = 0.0;                    ///< width of the field of these cells
  double pixel_arcmin = 0.0;                    ///< side of a pixel of the pictures
  int size_px = 0;                              ///< odd
  std::vector<std::string> notes, input_files;  ///< for the manifest; absolute paths of further files
  std::shared_ptr<const Json> resolved;         ///< the document with every default spelt out
};

/// Validates and reads a document of point spreads; `file` names it in errors and is where relative paths start. Throws
/// InputError.
PsfSpec read_psf_spec(const Json& document, const std::string& file);

}  // namespace sturm
