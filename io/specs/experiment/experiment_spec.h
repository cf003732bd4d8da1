#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/specs/experiment/bench_spec.h"
#include "io/specs/experiment/depth_psf_study_spec.h"
#include "io/specs/experiment/design_study_spec.h"
#include "io/specs/experiment/figure_spec.h"
#include "io/specs/experiment/lens_study_spec.h"
#include "io/specs/experiment/picture_experiment.h"
#include "io/specs/experiment/sampling_study_spec.h"
#include "io/specs/experiment/sin2_study_spec.h"
#include "io/specs/eye_spec.h"
#include "io/specs/ray_bundle_spec.h"

namespace sturm {

struct NamedPrescription {
  std::string id, note;
  Prescription prescription;
};

/// Every prescription × distance × pupil is one case, for the conoid and for each ray model.
struct EllipseExperiment {
  std::vector<NamedPrescription> prescriptions;  ///< ids are unique
  std::vector<double> distances_m;               ///< > 0, ∞ allowed
  std::vector<double> pupil_diameters_m;
  Accommodation accommodation;
  std::vector<RayModel> ray_models;
  RayBundleSpec rays;  ///< count × replicates
};

/// The image of one point-like emitter on the line of sight.
struct PsfExperiment {
  std::string id;
  std::string prescription;  ///< id
  Eye eye;
  double distance_m = 0.0;  ///< > 0, ∞ allowed
  std::vector<RayModel> ray_models;
  int resolution = 0;  ///< [px], square
  std::uint64_t samples_per_pixel = 0;
};

/// A validated document of format sturm.experiment/1.
struct ExperimentSpec {
  std::string title;
  std::uint64_t seed = 1;
  std::optional<std::filesystem::path> reference;  ///< absolute
  std::optional<EllipseExperiment> ellipses;
  std::vector<PsfExperiment> psfs;          ///< ids are unique
  std::vector<PictureExperiment> pictures;  ///< ids are unique among those with the same measures
  bool share_views = true;                  ///< pictures that are the same are rendered once
  std::optional<LensStudySpec> lens_study;
  std::optional<Sin2StudySpec> sin2_study;
  std::optional<DesignStudySpec> design_study;
  std::optional<SamplingStudySpec> sampling_study;
  std::optional<DepthPsfStudySpec> depth_psf_study;
  std::optional<BenchSpec> bench;                 ///< its seed is that of the experiment
  std::vector<FigureSpec> figures;                ///< ids are unique
  std::vector<std::string> mutations;             ///< errors that the gates are shown, by name
  std::filesystem::path gates;                    ///< absolute; empty: nothing is judged
  std::optional<std::filesystem::path> baseline;  ///< absolute; need not exist yet
  std::vector<std::string> input_files;           ///< absolute paths of all further files that are named and exist
  std::shared_ptr<const Json> resolved;           ///< the document with every default spelt out, paths as given
};

/// Validates and reads an experiment; `file` names it in errors and is where relative paths start. Throws InputError.
ExperimentSpec read_experiment(const Json& document, const std::string& file);

}  // namespace sturm
