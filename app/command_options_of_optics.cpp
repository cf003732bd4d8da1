#include "app/command_options.h"
#include "io/specs/sensor_table.h"

namespace sturm {

void CommandLine::add_ellipse() {
  auto* e = app.add_subcommand("ellipse", "blur ellipses at a list of targets, from a query or from --rx");
  add_documents(*e, common, "queries (sturm.ellipse/1)", "ellipse");
  add_run_options(*e, common);
  add_wearer(*e, common);
  add_spectacles(*e, common);
  e->add_option("--distance", ellipse.distances_m, "of the targets [m], with commas between: 0.4,1,6,inf")
      ->delimiter(',')
      ->allow_extra_args(false);
  e->add_option("--gaze", ellipse.gazes_deg, "AZIMUTH,ELEVATION to the wearer's right and up [deg]; may be repeated")
      ->allow_extra_args(false);
  e->add_option("--method", ellipse.methods,
                "how it is computed: conoid (default), rays:power_matrix, …; may be repeated")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_answer_kinds(*e, ellipse.answer, "a query");
  e->add_option("-o,--output", ellipse.output,
                "file instead of standard output (.csv, .json, or .txt for a table); of several queries' JSON a "
                "folder, or a name with {name}");
  e->callback([this] { action = [this] { return ellipse_command(common, ellipse); }; });
}

void CommandLine::add_lens() {
  auto* l = app.add_subcommand("lens",
                               "powers, thickness and as-worn power map of a spectacle lens, from a file or from --rx");
  add_documents(*l, common, "lenses (sturm.spectacles/1, .oma, .vca, .sdf or .zmx)", "spectacles");
  add_prescription(*l, common, "a single-vision or progressive lens");
  l->add_option("--index", lens.refractive_index, "its refractive index")->check(CLI::Range(1.0, 4.0));
  l->add_option("--thickness", lens.center_thickness_mm, "its thickness at the centre [mm]")
      ->check(CLI::PositiveNumber);
  l->add_option("--diameter", lens.diameter_mm, "its diameter [mm]")->check(CLI::PositiveNumber);
  l->add_option("--azimuth-deg", lens.azimuths_deg, "gazes to the wearer's right [deg]: FIRST:LAST:STEP or one angle")
      ->capture_default_str();
  l->add_option("--elevation-deg", lens.elevations_deg, "gazes up [deg]: FIRST:LAST:STEP or one angle")
      ->capture_default_str();
  l->add_option("--rotation-center-mm", lens.rotation_center_mm, "the eye's centre of rotation behind its pupil [mm]")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  l->add_option(
      "--map", lens.map_file,
      "picture of mean power error and cylinder over each lens, as worn, and of what each further lens has more "
      "than the first (.svg, .png or .pdf)");
  l->add_option("--defocus-map", lens.defocus_map_file,
                "picture of what the eye has too much or too little for targets at given distances");
  l->add_option("--corridor", lens.corridor_file, "picture of progressive lenses along their corridors");
  l->add_option("--ellipses", lens.ellipses_file,
                "picture of the blur ellipses over the field of gaze of the eyes that the lenses correct");
  l->add_option("--distance", lens.distances_m,
                "of the targets of these pictures [m], with commas between; inf = far away")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  l->add_option("--pupil", lens.eye.pupil_mm, "of the eye, for --ellipses [mm] (default: 4)")
      ->check(CLI::Range(0.01, 100.0));
  auto* age = l->add_option("--age", lens.eye.age_years, "of the eye, from which its accommodation follows [years]");
  age->check(CLI::Range(0.0, 150.0));
  l->add_option("--amplitude", lens.eye.amplitude_D, "or its amplitude of accommodation itself [D]")
      ->check(CLI::Range(0.0, 100.0))
      ->excludes(age);
  l->add_option("--range", lens.range, "end of the scale of all maps [D]")->check(CLI::PositiveNumber);
  add_answer_kinds(*l, lens.answer, "a file");
  l->add_option("-o,--output", output,
                "file instead of standard output (.csv, .json, or .txt for a table); of several lenses' JSON a "
                "folder, or a name with {name}");
  l->callback([this] { action = [this] { return lens_command(common, lens, output); }; });
}

void CommandLine::add_blurfield() {
  auto* b =
      app.add_subcommand("blurfield", "blur ellipses over the whole field of view and all distances: a multi-part EXR");
  add_document(*b, common, "blur field (sturm.blurfield/1)", "blurfield")->required(false);
  add_work_options(*b, common);
  add_wearer(*b, common);
  add_spectacles(*b, common);
  auto* output_option = b->add_option("-o,--output", blurfield.output, "EXR file; a manifest appears beside it");
  b->add_option("--layers", blurfield.layers, "SVG file: the ellipses at the distances layers_m");
  b->callback([this, output_option] {
    if (!common.print_config && output_option->empty()) throw CLI::RequiredError("--output");
    action = [this] { return blurfield_command(common, blurfield); };
  });
}

void CommandLine::add_psf() {
  auto* p = app.add_subcommand("psf", "point spreads of an eye over distance, by rays and by waves");
  add_documents(*p, common, "point spreads (sturm.psf/1)", "psf");
  add_wearer(*p, common);
  p->add_option("--distance", psf.distances_m, "of point sources [m], with commas between; inf = far away")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_threads(*p, common);
  add_answer_kinds(*p, psf.answer, "a document");
  p->add_option("-o,--output", psf.output,
                "file instead of standard output (.csv, .json, or .txt for a table); of several documents' JSON a "
                "folder, or a name with {name}");
  p->add_option("--images", psf.images, "EXR file with a picture of each point spread; a PNG of all appears beside it");
  p->callback([this] { action = [this] { return psf_command(common, psf); }; });
}

void CommandLine::add_wavefront() {
  WavefrontOptions& w = wavefront;
  auto* c = app.add_subcommand("wavefront", "Zernike coefficients and an eye's file from slopes, spots or heights");
  auto* file =
      c->add_option("file", w.file, "CSV of slopes, pairs of spots or heights, or the JSON of an eye to restate");
  take_shipped_paths(*file);
  c->add_option("-o,--output", w.output, "file for the eye (sturm.eye/1)");
  c->add_option("--report", w.report, "file for the fit's report instead of standard output");
  c->add_option("--residuals", w.residuals, "CSV file: what the fit leaves at each spot");
  c->add_option("--pupil-mm", w.pupil_mm, "diameter of the pupil that the coefficients are for [mm]");
  c->add_option("--eye-pupil-mm", w.eye_pupil_mm, "diameter of the eye's own pupil [mm] (default: the same)");
  c->add_option("--lenslet-mm", w.lenslet_mm, "side of a lenslet [mm], over which its slope is the mean");
  c->add_option("--gradient", w.gradient, "mean over the lenslet (default), or at its center")
      ->check(CLI::IsMember({"mean", "center"}));
  c->add_option("--order", w.order, "radial order 1 ... 20, or auto: the one that best predicts spots left out")
      ->capture_default_str();
  c->add_option("--center", w.center, "X Y of the pupil's centre in the table's own unit and frame")->expected(2);
  c->add_option("--frame", w.frame, "of the table: examiner (default), wearer, or image (y down; default for px)")
      ->check(CLI::IsMember(table_frame_words.all()));
  c->add_flag("--negative-slopes", w.negative_slopes, "the slopes are minus the gradient of the wavefront");
  c->add_option("--pixel-um", w.pixel_um, "side of a pixel [um], for columns in px");
  c->add_option("--focal-length-mm", w.focal_length_mm, "of the lenslets [mm], for pairs of spots");
  c->add_option("--grid-step-mm", w.grid_step_mm, "between the heights of a plain matrix [mm]");
  c->add_option("--wavelength-nm", w.wavelength_nm, "that the wavefront is stated for [nm]");
  c->add_option("--noise", w.noise, "standard deviation of a slope [rad] or height [um], if it is known");
  c->add_flag("--keep-spurious", w.keep_spurious, "fit all spots, also those that do not belong");
  c->add_flag("--drop-outside", w.drop_outside, "leave out spots outside of the pupil");
  c->add_flag("--no-tilt", w.no_tilt, "leave piston and tilt out of the eye's file");
  c->add_option("--side", w.side, "which eye it is")->check(CLI::IsMember({"right", "left"}));
  c->add_flag("--mirror", w.mirror, "write the mirrored wavefront, as of the other eye");
  c->add_flag("--random", w.random, "draw a random eye of a population instead of reading a file");
  c->add_option("--seed", w.seed, "of the random eye")->capture_default_str();
  c->callback([this] { action = [this] { return wavefront_command(wavefront); }; });
}

void CommandLine::add_stress() {
  auto* s = app.add_subcommand("stress", "numerical stability of conoid tracing over random and extreme cases");
  s->add_option("--cases", stress.cases, "number of cases")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40))
      ->capture_default_str();
  s->add_option("--case", stress.replayed, "print this case in full instead: input, results and checks")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 40));
  add_run_options(*s, common);
  s->add_option("-o,--output", output, "file for the report (sturm.stress_report/1), or for the case");
  s->callback([this] { action = [this] { return stress_command(common, stress, output); }; });
}

void CommandLine::add_plan_samples() {
  auto* p = app.add_subcommand("plan-samples", "number of independent rays that a measurement needs");
  p->add_option("--difference", plan.relative_difference, "relative difference to be seen")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  p->add_option("--sigma", plan.sigmas, "standard errors from which on it counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  p->add_option("--power", plan.power, "chance that it counts if it is there, 0 … 1")
      ->check(CLI::Range(1e-9, 1.0 - 1e-9))
      ->capture_default_str();
  p->add_flag("--both-measured", plan.both_measured, "the other side is measured by as many rays, not known");
  p->add_option("--kurtosis", plan.kurtosis, "of the rays along a semi-axis; 2 for a uniform disc")
      ->check(CLI::Range(1.0001, 1e9))
      ->capture_default_str();
  p->add_option("--coefficient-of-variation", plan.coefficient_of_variation,
                "of single samples: plan for a mean instead of a semi-axis")
      ->check(CLI::PositiveNumber);
  p->callback([this] { action = [this] { return plan_samples_command(plan); }; });
}

}  // namespace sturm
