#pragma once
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "io/json/json.h"
#include "io/specs/blur_field_spec.h"

namespace sturm {

/// A picture that another command drew.
struct FigureFile {
  std::filesystem::path file;  ///< absolute; SVG
};

/// Layers of blur ellipses of a blur field.
struct EllipseLayersFigure {
  BlurFieldSpec field;
};

/// The conoid of Sturm of one line of sight in space.
struct SturmConoidFigure {
  Eye eye;
  std::optional<Spectacles> spectacles;
  double azimuth = 0.0, elevation = 0.0;  ///< of the gaze [rad]
  double end_m = 1.0;                     ///< where the drawing ends
};

/// Maps of mean power error and cylinder of a lens as worn.
struct LensMapsFigure {
  SpectaclesSpec lens;  ///< it has a lens
  double rotation_center_m = mean_rotation_center_m;
};

/// What an eye lacks behind each of some lenses for targets at one distance.
struct DefocusMapsFigure {
  std::vector<SpectaclesSpec> lenses;
  std::vector<std::string> names;  ///< of the lenses, for the titles
  double rotation_center_m = mean_rotation_center_m;
  double distance_m = 0.4;  ///< > 0, ∞ allowed
  double amplitude_D = 0.0;
};

/// A picture of a report: drawn elsewhere, or by the run.
struct FigureSpec {
  std::string id, title, caption, command;
  std::variant<FigureFile, EllipseLayersFigure, SturmConoidFigure, LensMapsFigure, DefocusMapsFigure> drawing;
  std::vector<std::string> input_files;  ///< absolute
};

/// Reads one entry of an experiment's "figures". Throws InputError.
FigureSpec read_figure(const Json& value, const Source& where);

}  // namespace sturm
