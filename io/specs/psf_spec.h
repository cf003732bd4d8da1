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

inline constexpr Words<PsfModel, 2> psf_model_words{{{PsfModel::Rays, "rays"}, {PsfModel::Waves, "waves"}}};

/// A light with the name that results have for it.
struct NamedLight {
  std::string id;
  Light light;
};

/// A point source before the eye.
struct PsfTarget {
  std::optional<double> distance_m;  ///< none where the vergence error was given itself
  double accommodation_D = 0.0;
  double vergence_D = 0.0;  ///< the error V that is added to the wave of the relaxed eye
};

/// A validated document of format sturm.psf/1.
struct PsfSpec {
  Eye eye;
  double in_focus_nm = 555.0;
  std::vector<PsfModel> models;
  std::vector<NamedLight> lights;
  std::vector<PsfTarget> targets;
  bool examiner_frame = false;
  std::vector<double> frequencies_cpd, directions_deg, energy_shares;
  std::size_t ray_count = 0;
  std::optional<int> wave_grid;
  std::vector<double> cells_arcmin;
  double field_arcmin = 0.0;
  double pixel_arcmin = 0.0;
  int size_px = 0;  ///< odd
  std::vector<std::string> notes, input_files;
  std::shared_ptr<const Json> resolved;  ///< the document with every default spelt out
};

/// Validates and reads a document of point spreads; `file` names it in errors and is where relative paths start. Throws
/// InputError.
PsfSpec read_psf_spec(const Json& document, const std::string& file);

}  // namespace sturm
