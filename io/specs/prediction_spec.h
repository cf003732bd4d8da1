#pragma once
#include <string>
#include <vector>

#include "io/files/error.h"
#include "io/json/json.h"
#include "io/specs/seen_psf.h"
#include "lensmodel/eye.h"
#include "lensmodel/words.h"

namespace sturm {

/// How a picture is predicted without lens sampling.
enum class PredictionKind {
  Ellipses,   ///< one sharp layer spread by ellipses, hidden surfaces guessed; naked eye in `camera` gaze
  Layered,    ///< ellipses of every surface that the pupil sees, hidden ones found by rays; any eye and gaze
  Multipass,  ///< passes through points of the pupil, blended; any eye and gaze
  DepthPsf    ///< the same surfaces as Layered, blurred by point spreads over depth; naked eye in `camera` gaze
};

inline constexpr Words<PredictionKind, 4> prediction_kind_words{{{PredictionKind::Ellipses, "ellipses"},
                                                                 {PredictionKind::Layered, "layered"},
                                                                 {PredictionKind::Multipass, "multipass"},
                                                                 {PredictionKind::DepthPsf, "depth_psf"}}};

/// The word for it in documents.
inline std::string name_of(PredictionKind kind) {
  return std::string(prediction_kind_words.word_of(kind));
}

/// Distinguishes all that one list of predictions may hold: that word, and "depth_psf_waves".
inline std::string name_of(PredictionKind kind, SeenPsf psf) {
  const bool waves = kind == PredictionKind::DepthPsf && psf == SeenPsf::Waves;
  return name_of(kind) + (waves ? "_waves" : "");
}

struct PredictionSpec {
  PredictionKind kind = PredictionKind::Ellipses;
  int passes = 64;              ///< through points of the pupil (multipass)
  bool smooth = true;           ///< filter the noise of the sharp view (all but ellipses)
  int oversampling = 1;         ///< sharp pixels per output pixel along each side
  SeenPsf psf = SeenPsf::Rays;  ///< (depth_psf)
  int pupil_parts = 4;          ///< that are composited by themselves (depth_psf by rays)
};

/// Reads "prediction", "passes", "smooth", "oversampling", "psf" and "pupil_parts" of an object. Throws InputError
/// where they do not fit together.
PredictionSpec read_prediction(const Json& value, const Source& where);

/// Diffraction needs a pupil. Throws InputError at `where`, the eye's place, for a pinhole.
void require_pupil(const PredictionSpec& prediction, const Eye& eye, const Source& where);

/// The keys among them that say nothing about a kind of prediction, so that read_prediction refuses them: of a resolved
/// document they are left out.
std::vector<std::string> keys_without_meaning(const Json& method);

}  // namespace sturm
