#pragma once
#include <string>
#include <vector>

#include "app/commands.h"
#include "experiments/figures/lens_plots.h"
#include "io/json/json.h"

namespace sturm {

/// An eye that is plotted, with what it wears.
struct PlottedEye {
  std::string name;  ///< for people: the file's, or the prescription
  WornEye worn;
  Json eye;          ///< sturm.eye/1, resolved, in case that point spreads are asked for
  std::string file;  ///< for messages
};

/// The eyes that the options name. A file is an eye, a document with an eye, or a lens: then the eye is the one that it
/// corrects, behind it. Without files the eye of --rx. Pupil and accommodation are those of the options where these
/// state them; --lens stands before every eye. Throws InputError.
std::vector<PlottedEye> plotted_eyes(const PlotOptions& options);

/// The eye that a lens corrects, behind it, with this pupil (none: 4 mm) and accommodation.
PlottedEye eye_behind(const NamedLens& lens, const std::string& file, const WearerOptions& worn);

/// The lens that is made for a prescription where no file says more.
Json usual_lens();

/// The lenses that the options name; without files the usual one for --rx. Throws InputError where a file is no lens.
std::vector<NamedLens> plotted_lenses(const PlotOptions& options);

/// Eyes as figures of several have them.
std::vector<NamedEye> named_eyes(const std::vector<PlottedEye>& eyes);

/// Throws InputError where so many panels do not fit side by side.
void require_few_panels(std::size_t panels);

}  // namespace sturm
