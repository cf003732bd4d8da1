#pragma once
#include <string>
#include <vector>

#include "io/specs/eye_spec.h"
#include "io/specs/ray_bundle_spec.h"

namespace sturm {

/// An eye of the study: of the grid, or a real one.
struct StudyEye {
  std::string id;
  Prescription prescription;
};

/// Neighbouring eyes that are traced as one part of the run.
struct StudyEyeGroup {
  std::string name;  ///< fit for a file name
  std::size_t begin = 0, end = 0;
};

/// One view whose point-spread functions are shown.
struct Sin2GalleryView {
  std::string id, title;
  Eye eye;
  double distance_m = 0.0;  ///< > 0, ∞ allowed
};

/// What sin² interpolation and added focal distances do to the blur: every eye × distance × pupil × accommodation × ray
/// model.
struct Sin2StudySpec {
  std::vector<StudyEye> eyes;  ///< first the grid, then the real ones
  std::size_t grid_eyes = 0;   ///< stated at the cornea
  std::vector<StudyEyeGroup> groups;
  std::vector<double> spheres_D, cylinders_D,
      axes_deg;                               ///< of the grid, as given; no cylinder needs no axis and is there once
  std::vector<double> distances_m;            ///< > 0, ∞ allowed
  std::vector<double> pupil_diameters_m;      ///< > 0
  std::vector<Accommodation> accommodations;  ///< metalstigmatism is undefined without a stated focus distance
  QuadratureSpec quadrature;                  ///< of the pupil
  PupilSamplingSpec rings;                    ///< kind Rings
  std::size_t reference_pupil = 0, reference_distance = 0,
              reference_accommodation = 0;  ///< indices of the view that figures show
  std::uint64_t gallery_rays = 0;           ///< per picture
  std::vector<Sin2GalleryView> gallery;
  std::vector<std::string> input_files;  ///< absolute paths
};

/// Reads a validated "sin2_study" section with its defaults spelt out. Throws InputError.
Sin2StudySpec read_sin2_study(const Json& value, const Source& where);

}  // namespace sturm
