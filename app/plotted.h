#pragma once
#include <string>
#include <vector>

#include "app/commands.h"
#include "io/json/json.h"
#include "io/specs/worn_eye_spec.h"
#include "lensmodel/power_matrix.h"

namespace sturm {

/// An eye that is plotted, with what it wears.
struct PlottedEye {
  std::string name;  ///< for people: the file's, or the prescription
  WornEye worn;
  Json eye;          ///< sturm.eye/1, resolved, in case that point spreads are asked for
  std::string file;  ///< for messages
};

/// A lens that is plotted.
struct PlottedLens {
  std::string name;
  Spectacles lens;
  PowerMatrix nominal;  ///< that it was made for, or has on its axis
};

/// The eyes that the options name. A file is an eye, a document with an eye, or a lens: then the eye is the one that it
/// corrects, behind it. Without files the eye of --rx. Pupil and accommodation are those of the options where these
/// state them; --lens stands before every eye. Throws InputError.
std::vector<PlottedEye> plotted_eyes(const PlotOptions& options);

/// The lenses that the options name. Throws InputError where a file is no lens.
std::vector<PlottedLens> plotted_lenses(const PlotOptions& options);

}  // namespace sturm
