#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/text_answers.h"
#include "io/files/sandbox.h"
#include "lensmodel/eye.h"

namespace sturm {

/// What options say of the wearer in place of the document, besides the prescription; "" and none are what was not
/// given.
struct WearerOptions {
  std::string eye;                  ///< a file, or the name of a shipped eye; what follows changes it
  std::optional<double> vertex_mm;  ///< distance of the lens that the prescription is written for
  std::optional<double> pupil_mm;
  std::optional<double> age_years, amplitude_D;  ///< accommodation as good as it can be; at most one of three
  std::string focus_m;                           ///< accommodation at one distance: > 0 or "inf"
  std::string lens;                              ///< spectacles: a file, or the name of a shipped lens
};

/// What several commands take.
struct CommonOptions {
  std::string file;                      ///< the configuration; "-" is standard input, "" = none was given
  std::string schema;                    ///< of the configuration: "ellipse" for sturm.ellipse/1; "" = any
  std::vector<std::string> assignments;  ///< --set /pointer=value
  std::string prescription;              ///< --rx, in optical notation; "" = as in the configuration
  WearerOptions worn;
  bool print_config = false;  ///< print the configuration with all that the options change, and do nothing
  std::optional<std::uint64_t> seed;
  int threads = 0;  ///< 0: one per processor
  bool quiet = false;
  std::vector<std::string> files;  ///< of a command that answers several by themselves; `file` is one of them
};

/// Bounds that turn `sturm compare` into a gate; none of them set: it only reports.
struct CompareOptions {
  std::string test, reference;
  std::vector<std::string> layers;  ///< of EXR files: one for all, or the test's and the reference's
  std::string json_file;            ///< "" = none, "-" = standard output instead of the table
  double exposure = 1.0;
  std::optional<double> pixels_per_degree;  ///< none: from the pictures' metadata, or that of FLIP's default observer
  std::vector<double> hdr_exposures;        ///< START STOP COUNT of HDR-FLIP [powers of two]; empty: by its rule
  std::vector<std::string> noise;           ///< the test's view with another seed, and the reference's
  bool regions = false;
  std::vector<int> edge;               ///< X Y WIDTH HEIGHT of a slanted edge [px]
  bool psf = false;                    ///< the pictures are also images of a point
  std::optional<double> pixel_arcmin;  ///< for `psf`; none: from the metadata
  std::string maps_folder;             ///< "" = no error maps
  std::vector<std::string> bounds;     ///< KEY=VALUE
  std::optional<double> min_ssim, min_psnr_dB, max_rmse, max_relative_mse;
  std::string suite;            ///< folder of pairs instead of the two pictures; "" = none
  bool beyond_noise = false;    ///< a pair of the suite fails where it differs by more than its seeds do
  std::string junit, markdown;  ///< files; "" = none
};

/// What `sturm plan-samples` is asked for.
struct PlanOptions {
  double relative_difference = 1e-3, sigmas = 4.0, power = 0.5;
  bool both_measured = false;
  double kurtosis = 2.0;                           ///< of rays along a semi-axis
  std::optional<double> coefficient_of_variation;  ///< of single samples of a mean; none: a semi-axis
};

/// What `sturm ellipse` is asked for beside the query.
struct EllipseOptions {
  std::vector<std::string> distances_m, gazes_deg, methods;  ///< in place of the query's; empty = as there
  AnswerOptions answer;                                      ///< else JSON for a file, a table for a line
  std::string output;                                        ///< file; "" = standard output
};

/// What `sturm lens` is asked for.
struct LensOptions {
  std::optional<double> refractive_index, center_thickness_mm, diameter_mm;  ///< of a lens that is made
  std::string azimuths_deg = "-40:40:10", elevations_deg = "-40:40:10";      ///< FIRST:LAST:STEP, or one angle
  double rotation_center_mm = 1e3 * mean_rotation_center_m;                  ///< behind the pupil
  std::string map_file, defocus_map_file, corridor_file, ellipses_file;      ///< .svg, .png or .pdf; "" = none
  std::vector<std::string> distances_m{"0.4"};                               ///< of targets: > 0 or "inf"
  WearerOptions eye;            ///< pupil and accommodation of the eye behind the lens
  std::optional<double> range;  ///< end of the scale of all maps [D]
  AnswerOptions answer;         ///< else JSON for a file, a table for a line and for several files
};

/// What `sturm plot` is asked for.
struct PlotOptions {
  std::string kind;
  std::vector<std::string> files;        ///< eyes, lenses, or documents with an eye; empty: by `prescription`
  std::string prescription, spectacles;  ///< --rx and --lens; "" = none
  WearerOptions worn;                    ///< pupil and accommodation, in place of the eye's own
  std::vector<std::string> distances_m;  ///< of targets: > 0 or "inf"; empty: as the kind has it
  std::optional<double> range;           ///< end of the scale
  double nearest_m = 0.2, clear_D = 0.25;
  std::string psf = "waves";  ///< or "rays", "both"
  bool difference = false;    ///< of two lenses, beside them
  double rotation_center_mm = 1e3 * mean_rotation_center_m;
  std::string output, csv;  ///< "" = beside the picture
};

/// What `sturm validate-camera` is asked for.
struct ValidateCameraOptions {
  std::string folder;
  bool write = false;                       ///< the scene, instead of judging a picture of it
  std::string eye, prescription;            ///< that the camera has; "" = a thin lens in focus at `focus_m`
  std::optional<double> pupil_mm, focus_m;  ///< of it
  std::string picture;                      ///< "" = picture.exr in the folder
  double relative = 0.02, absolute_px = 0.1, centroid_px = 0.15, orientation_deg = 2.0;  ///< tolerances
  std::string junit, markdown;
};

/// What `sturm wearers` is asked for.
struct WearersOptions {
  std::string table;                            ///< CSV of prescriptions
  std::vector<std::string> lenses;              ///< designs that each wearer tries
  std::vector<std::string> distances_m{"inf"};  ///< of targets: > 0 or "inf"
  std::optional<double> age, amplitude_D;       ///< of all wearers, in place of the ages in the table
  double clear_D = 0.25, reach_deg = 30.0, step_deg = 5.0, vertex_mm = 12.0;
  std::string output;  ///< CSV, "" = standard output
};

/// What `sturm blurfield` writes.
struct BlurFieldOptions {
  std::string output;  ///< EXR
  std::string layers;  ///< SVG, "" = not drawn
};

/// What `sturm see` is asked for beside the eye; "", none and empty are what was not given.
struct SeeOptions {
  std::string picture, output;      ///< a picture or a document; where the result goes
  std::string depth;                ///< depth map
  std::vector<std::string> layers;  ///< pictures of hidden surfaces
  std::string picture_layer;        ///< of EXR files with several pictures
  std::string distance_m;           ///< of a flat picture: > 0 or "inf"
  std::optional<double> vfov_deg, hfov_deg;
  std::string depth_unit;  ///< "m", "mm", "D"
  std::optional<double> depth_scale;
  bool disparity = false;      ///< the depth map holds disparities
  std::string disparity_file;  ///< that map, if --disparity names it
  std::optional<double> focal_px, baseline_m, doffs_px;
  std::optional<double> focus_D;  ///< accommodation as a power
  std::optional<int> parts;       ///< of the pupil
  std::optional<double> error;    ///< beside edges, from which the parts follow
  std::string psf;                ///< "rays" or "waves"
  bool chromatic = false, explain = false;
  std::optional<double> exposure;  ///< of a PNG
  std::optional<int> png_bits;
  std::vector<double> rack_focus_D, pupil_sequence_mm;  ///< first and last of a sequence of frames
  std::optional<int> frames;
  bool film = false;  ///< the frames are joined
};

/// What `sturm serve` is asked for.
struct ServeOptions {
  std::string page_template;  ///< the page without data, "" = the one that was built
  int port = 0;               ///< 0: any that is free
};

/// What `sturm render` changes in its view, and writes beside its picture.
struct PreviewOptions {
  std::optional<std::uint64_t> samples_per_pixel;
  std::string size;  ///< "480x320" [px]; "" = as in the view
  std::string file;  ///< PNG that is replaced while the picture grows; "" = none
  double interval_s = 2.0;
};

/// What `sturm stress` is asked for.
struct StressOptions {
  std::uint64_t cases = 1000000;
  std::optional<std::uint64_t> replayed;  ///< one case in full instead of the suite
};

/// What `sturm psf` is asked for, and writes.
struct PsfOptions {
  std::vector<std::string> distances_m;  ///< of point sources, in place of the document's; empty = as there
  std::string output;                    ///< "" = standard output
  std::string images;                    ///< EXR; a PNG appears beside it; "" = none
  AnswerOptions answer;                  ///< else JSON for a document, a table for a line and for several documents
};

/// What `sturm wavefront` is asked for; "" and none are what was not given.
struct WavefrontOptions {
  std::string file;  ///< CSV of a sensor or heights, or the JSON of an eye; "" with `random`
  std::optional<double> pupil_mm, eye_pupil_mm, lenslet_mm, pixel_um, focal_length_mm, grid_step_mm, wavelength_nm,
      noise;
  std::vector<double> center;  ///< X Y of the pupil in the table's own unit and frame
  std::string gradient, frame, side;
  std::string order = "auto";
  bool negative_slopes = false, keep_spurious = false, drop_outside = false, no_tilt = false, mirror = false;
  bool random = false;
  std::uint64_t seed = 1;
  std::string output, report, residuals;  ///< files: the eye, the report ("" = standard output), a CSV of residuals
};

struct GateOptions {
  std::string report, gates, baseline, junit, markdown, new_baseline;  ///< "" = not given
};

/// What `sturm compare-runs` is asked for.
struct CompareRunsOptions {
  std::string before, after;  ///< run folders or report.json files
  std::string json_file;      ///< "" = none, "-" = standard output instead of the table
  double level = 0.01;        ///< chance of any false alarm in the whole comparison
  bool gate = false;          ///< exit status 1 where something is worse
};

/// What `sturm init` writes.
struct InitOptions {
  std::string kind;    ///< "experiment", "view", "lens", …
  std::string folder;  ///< that it is written into
};

// Each command returns the exit status; errors are thrown as InputError (2) or RuntimeFailure (3).
int ellipse_command(const CommonOptions& common, const EllipseOptions& options);
int blurfield_command(const CommonOptions& options, const BlurFieldOptions& files);
int lens_command(const CommonOptions& options, const LensOptions& lens, const std::string& output);
int plot_command(const PlotOptions& options);
int wearers_command(const WearersOptions& options);
int validate_camera_command(const ValidateCameraOptions& options);
int render_command(const CommonOptions& options, const PreviewOptions& preview, const std::string& output);
int view_command(const CommonOptions& options, const std::string& template_file, const std::string& output);
int serve_command(const CommonOptions& options, const ServeOptions& serve);
int explain_command(const CommonOptions& options, const PreviewOptions& preview);  ///< sturm render --explain
int see_command(const CommonOptions& common, const SeeOptions& options);
int run_command(const CommonOptions& options, const std::string& folder, bool resume);
int bench_command(const CommonOptions& options, const std::string& folder, bool resume);
int stress_command(const CommonOptions& options, const StressOptions& stress, const std::string& output);
int compare_command(const CompareOptions& options);
int compare_suite_command(const CompareOptions& options);  ///< sturm compare --suite
int compare_runs_command(const CompareRunsOptions& options);
int psf_command(const CommonOptions& options, const PsfOptions& asked);
int wavefront_command(const WavefrontOptions& options);
int plan_samples_command(const PlanOptions& options);
int gate_command(const GateOptions& options);
int report_command(const std::string& run, const std::string& output);
int validate_command(const std::vector<std::string>& files);
int schema_command(const std::string& name);
int init_command(const InitOptions& options);
int doctor_command();

}  // namespace sturm
