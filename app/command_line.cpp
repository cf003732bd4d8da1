#include "app/command_line.h"

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <sstream>

#include "app/commands.h"
#include "io/files/build_info.h"
#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/files/sandbox.h"
#include "io/files/standard_output.h"
#include "io/json/manifest.h"
#include "io/specs/sensor_table.h"

namespace sturm {

namespace {

enum ExitStatus { passed = 0, failed = 1, wrong_input = 2, runtime_failure = 3 };

std::string version_text() {
  const BuildInfo& b = build_info();
  return "sturm " + std::string(b.version) + " (commit " + std::string(b.commit) + ")\nbuilt with " +
         std::string(b.compiler) + ", " + std::string(b.build_type) + ", flags " + std::string(b.flags) +
         "\ninstruction set " + instruction_set() + "\n";
}

void add_document(CLI::App& command, CommonOptions& options, const char* what) {
  command.add_option("file", options.file, std::string(what) + " (- is standard input)")->required();
  command.add_option("--set", options.assignments, "change the configuration: /json/pointer=value; may be repeated")
      ->allow_extra_args(false);
}

void add_prescription(CLI::App& command, CommonOptions& options, const char* whose) {
  command.add_option("--rx", options.prescription,
                     std::string("prescription of ") + whose + ", in place of the document's: \"-2.00 -1.50 x 30\"");
}

void add_run_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--seed", options.seed, "seed of all random numbers");
  command.add_option("--threads", options.threads, "threads to use; 0 = one per processor")->check(CLI::Range(0, 1024));
  command.add_flag("--quiet", options.quiet, "no progress on stderr");
}

void add_common_options(CLI::App& command, CommonOptions& options, const char* what) {
  add_document(command, options, what);
  add_run_options(command, options);
}

/// The commands with their options; `action` is what the chosen one does.
struct CommandLine {
  CLI::App app{"Sturm: the blur of an astigmatic eye, path traced and predicted, and whether the two agree.", "sturm"};
  CommonOptions common;
  LensOptions lens;
  BlurFieldOptions blurfield;
  PreviewOptions preview;
  SeeOptions see;
  StressOptions stress;
  CompareOptions compare;
  CompareRunsOptions compare_runs;
  PlanOptions plan;
  GateOptions gate;
  PsfOptions psf;
  WavefrontOptions wavefront;
  std::string output, folder, file, schema;
  bool resume = false, explain = false;
  std::function<int()> action;

  CommandLine() {
    app.require_subcommand(1);
    app.set_version_flag("--version", version_text());
    app.add_flag_callback("--sandbox", enter_sandbox,
                          "for files that are not trusted: each may name only files in its own folder and below");
    add_run();
    add_ellipse();
    add_lens();
    add_blurfield();
    add_psf();
    add_wavefront();
    add_render();
    add_see();
    add_bench();
    add_stress();
    add_compare();
    add_compare_runs();
    add_plan_samples();
    add_gate();
    add_report();
    auto* validate = app.add_subcommand("validate", "check a configuration without running it");
    validate->add_option("file", file, "any document of Sturm (- is standard input)")->required();
    validate->callback([this] { action = [this] { return validate_command(file); }; });
    auto* schema_app = app.add_subcommand("schema", "print a JSON schema, or the names of all");
    schema_app->add_option("name", schema, "e.g. experiment");
    schema_app->callback([this] { action = [this] { return schema_command(schema); }; });
    for (CLI::App* command : app.get_subcommands({})) command->fallthrough();
  }

  void add_run() {
    auto* run = app.add_subcommand("run", "run an experiment and write its report");
    add_common_options(*run, common, "experiment (sturm.experiment/1)");
    run->add_option("--out", folder, "folder of the report (default: reports/runs/NAME)");
    run->add_flag("--resume", resume, "take over what an interrupted run has finished");
    run->callback([this] { action = [this] { return run_command(common, folder, resume); }; });
  }

  void add_ellipse() {
    auto* ellipse = app.add_subcommand("ellipse", "blur ellipses for a list of targets: JSON in, JSON out");
    add_common_options(*ellipse, common, "query (sturm.ellipse/1)");
    add_prescription(*ellipse, common, "the eye");
    ellipse->add_option("-o,--output", output, "file instead of standard output");
    ellipse->callback([this] { action = [this] { return ellipse_command(common, output); }; });
  }

  void add_lens() {
    auto* l =
        app.add_subcommand("lens", "powers, thickness and as-worn power map of a spectacle lens: JSON in, JSON out");
    add_document(*l, common, "lens (sturm.spectacles/1, .oma, .vca, .sdf or .zmx)");
    add_prescription(*l, common, "a single-vision or progressive lens");
    l->add_option("--azimuth-deg", lens.azimuths_deg, "gazes to the wearer's right [deg]: FIRST:LAST:STEP or one angle")
        ->capture_default_str();
    l->add_option("--elevation-deg", lens.elevations_deg, "gazes up [deg]: FIRST:LAST:STEP or one angle")
        ->capture_default_str();
    l->add_option("--rotation-center-mm", lens.rotation_center_mm, "the eye's centre of rotation behind its pupil [mm]")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    l->add_option("--map", lens.map_file,
                  "picture of mean power error and cylinder over the lens, as worn (.svg or .png)");
    l->add_option("--defocus-map", lens.defocus_map_file,
                  "picture of what the eye lacks for targets at given distances (.svg or .png)");
    l->add_option("--target-distance-m", lens.target_distances_m, "of the defocus map, up to four [m]; inf = far away")
        ->expected(1, 4)
        ->capture_default_str();
    l->add_option("--amplitude-D", lens.amplitude_D, "of the eye's accommodation, for the defocus map [D]")
        ->check(CLI::Range(0.0, 100.0))
        ->capture_default_str();
    l->add_option("-o,--output", output, "file instead of standard output");
    l->callback([this] { action = [this] { return lens_command(common, lens, output); }; });
  }

  void add_blurfield() {
    auto* b = app.add_subcommand("blurfield",
                                 "blur ellipses over the whole field of view and all distances: a multi-part EXR");
    add_common_options(*b, common, "blur field (sturm.blurfield/1)");
    add_prescription(*b, common, "the eye");
    b->add_option("-o,--output", blurfield.output, "EXR file; a manifest appears beside it")->required();
    b->add_option("--layers", blurfield.layers, "SVG file: the ellipses at the distances layers_m");
    b->callback([this] { action = [this] { return blurfield_command(common, blurfield); }; });
  }

  void add_psf() {
    auto* p =
        app.add_subcommand("psf", "point spreads of an eye over distance, by rays and by waves: JSON in, JSON out");
    add_document(*p, common, "point spreads (sturm.psf/1)");
    p->add_option("--threads", common.threads, "threads to use; 0 = one per processor")->check(CLI::Range(0, 1024));
    p->add_option("-o,--output", psf.output, "file instead of standard output");
    p->add_option("--images", psf.images,
                  "EXR file with a picture of each point spread; a PNG of all appears beside it");
    p->callback([this] { action = [this] { return psf_command(common, psf); }; });
  }

  void add_wavefront() {
    WavefrontOptions& w = wavefront;
    auto* c = app.add_subcommand("wavefront", "Zernike coefficients and an eye's file from slopes, spots or heights");
    c->add_option("file", w.file, "CSV of slopes, pairs of spots or heights, or the JSON of an eye to restate");
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

  void add_render() {
    auto* render = app.add_subcommand("render", "one image, path traced or predicted");
    add_common_options(*render, common, "view (sturm.render/1)");
    add_prescription(*render, common, "the eye");
    auto* file_option = render->add_option("-o,--output", output, "EXR file; a PNG and a manifest appear beside it");
    render->add_option("--preview", preview.file, "PNG file that shows the picture while it grows");
    render->add_option("--preview-interval-s", preview.interval_s, "seconds between two previews, at least")
        ->check(CLI::Range(0.0, 86400.0))
        ->capture_default_str();
    render->add_flag("--explain", explain, "print what the picture does without, and why; nothing is rendered")
        ->excludes(file_option);
    render->callback([this, file_option] {
      if (!explain && file_option->empty()) throw CLI::RequiredError("--output");
      action = [this] { return explain ? explain_command(common) : render_command(common, preview, output); };
    });
  }

  void add_see() {
    auto* s = app.add_subcommand("see", "any picture with a depth map, as an eye sees it");
    s->add_option("picture", see.picture, "sharp picture: EXR (linear), PNG, JPEG … (sRGB)")->required();
    s->add_option("--eye", see.eye, "eye (sturm.eye/1)")->required();
    auto* output_option = s->add_option("-o,--output", see.output, "PNG or EXR file; a manifest appears beside it");
    add_see_depth(*s);
    add_see_view(*s);
    s->add_flag("--explain", see.explain, "print what is done with each tile and layer; nothing is written")
        ->excludes(output_option);
    add_run_options(*s, common);
    s->callback([this, s, output_option] {
      see.disparity = s->count("--disparity") > 0;
      if (!see.explain && output_option->empty()) throw CLI::RequiredError("--output");
      action = [this] { return see_command(common, see); };
    });
  }

  void add_see_depth(CLI::App& s) {
    auto* depth =
        s.add_option("--depth", see.depth, "depth map: EXR, PFM or 16-bit PNG (default: the picture's own Z)");
    s.add_option("--layer", see.layers, "surface that the picture hides: EXR with R, G, B, Z and A; may be repeated")
        ->allow_extra_args(false);
    s.add_option("--distance-m", see.distance_m, "of a flat picture [m]; inf = far away")->excludes(depth);
    s.add_option("--depth-unit", see.depth_unit, "of the depth map (default: m; mm for a PNG without --depth-scale)")
        ->check(CLI::IsMember({"m", "mm", "D"}));
    s.add_option("--depth-scale", see.depth_scale, "factor of its numbers")->check(CLI::PositiveNumber);
    s.add_option("--disparity", see.disparity_file, "the depth map holds disparities [px]; its file, if not --depth")
        ->expected(0, 1)
        ->excludes("--depth-unit")
        ->excludes("--distance-m");
    s.add_option("--focal-px", see.focal_px, "focal length of the pair of cameras [px]")->check(CLI::PositiveNumber);
    s.add_option("--baseline-m", see.baseline_m, "their distance [m]")->check(CLI::PositiveNumber);
    s.add_option("--doffs-px", see.doffs_px, "what is added to a disparity: difference of their principal points [px]");
  }

  void add_see_view(CLI::App& s) {
    auto* vfov = s.add_option("--vfov-deg", see.vfov_deg, "field of view from top to bottom [deg]");
    vfov->check(CLI::Range(1e-3, 175.0));
    s.add_option("--hfov-deg", see.hfov_deg, "or from left to right [deg]")
        ->check(CLI::Range(1e-3, 175.0))
        ->excludes(vfov);
    s.add_option("--pupil-mm", see.pupil_mm, "pupil diameter in place of the eye's own [mm]")
        ->check(CLI::Range(0.0, 100.0));
    auto* focus_m = s.add_option("--focus-m", see.focus_m, "accommodation as a distance [m]; inf = relaxed");
    s.add_option("--focus-D", see.focus_D, "accommodation as a power [D]")
        ->check(CLI::Range(0.0, 1000.0))
        ->excludes(focus_m);
    auto* parts =
        s.add_option("--parts", see.parts, "parts of the pupil that are composited on their own (default: 4)");
    parts->check(CLI::Range(1, 64));
    s.add_option("--error", see.error, "root-mean-square error beside edges that parts are chosen for")
        ->check(CLI::PositiveNumber)
        ->excludes(parts);
    s.add_option("--psf", see.psf, "rays, or waves (with diffraction, in one part)")
        ->check(CLI::IsMember({"rays", "waves"}))
        ->capture_default_str();
    s.add_flag("--chromatic", see.chromatic, "red, green and blue are out of focus by different amounts");
    s.add_option("--exposure", see.exposure, "factor before the display transfer function of a PNG")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    auto* rack = s.add_option("--rack-focus-D", see.rack_focus_D, "FROM TO: frames with this accommodation [D]");
    rack->expected(2)->check(CLI::Range(0.0, 1000.0))->excludes("--focus-m")->excludes("--focus-D");
    s.add_option("--pupil-sequence-mm", see.pupil_sequence_mm, "FROM TO: frames with this pupil [mm]")
        ->expected(2)
        ->check(CLI::Range(0.0, 100.0))
        ->excludes("--pupil-mm");
    s.add_option("--frames", see.frames, "of a sequence")->check(CLI::Range(2, 100000))->capture_default_str();
  }

  void add_bench() {
    auto* bench = app.add_subcommand("bench", "run time against error: methods and settings over views");
    add_common_options(*bench, common, "benchmark (sturm.bench/1)");
    bench->add_option("--out", folder, "folder of the report (default: reports/runs/NAME)");
    bench->add_flag("--resume", resume, "take over the rounds that an interrupted run has finished");
    bench->callback([this] { action = [this] { return bench_command(common, folder, resume); }; });
  }

  void add_stress() {
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

  void add_compare() {
    auto* c = app.add_subcommand("compare", "metrics of two pictures; bounds make it a gate");
    c->add_option("test", compare.test, "EXR, HDR, PFM, PNG, JPEG, TIFF, …")->required();
    c->add_option("reference", compare.reference, "the same")->required();
    c->add_option("--layer", compare.layers,
                  "layer of EXR files with several: once for both, or for the test and again for the reference")
        ->allow_extra_args(false);
    c->add_option("--json", compare.json_file,
                  "write the metrics as JSON (- is standard output, instead of the table)");
    c->add_option("--exposure", compare.exposure, "factor before the display transfer function")
        ->check(CLI::PositiveNumber);
    c->add_option("--pixels-per-degree", compare.pixels_per_degree,
                  "of the observer, for FLIP (default: from the picture's field of view, or 67.02)")
        ->check(CLI::PositiveNumber);
    c->add_option("--hdr-exposures", compare.hdr_exposures,
                  "START STOP COUNT [powers of two] of HDR-FLIP (default: from the reference)")
        ->expected(3);
    c->add_option("--noise", compare.noise,
                  "the test's view with another seed, and the reference's: what noise alone makes of each metric")
        ->expected(1, 2);
    c->add_flag("--regions", compare.regions, "also in focus, blurred, at occlusion edges and in highlights");
    c->add_option("--edge", compare.edge, "X Y WIDTH HEIGHT [px]: MTF of the slanted edge in this rectangle")
        ->expected(4);
    c->add_flag("--psf", compare.psf, "the pictures are images of a point: compare them as point spread functions");
    c->add_option("--pixel-arcmin", compare.pixel_arcmin,
                  "width of a pixel for --psf [arcmin] (default: from the picture's field of view)")
        ->check(CLI::PositiveNumber);
    c->add_option("--maps", compare.maps_folder, "folder for a map of each metric in false colour (PNG)");
    c->add_option("--bound", compare.bounds,
                  "METRIC=VALUE: fail if the metric (its key in JSON) is worse; may be repeated")
        ->allow_extra_args(false);
    c->add_option("--min-ssim", compare.min_ssim, "fail below this SSIM (display space)");
    c->add_option("--min-psnr", compare.min_psnr_dB, "fail below this PSNR [dB] (display space)");
    c->add_option("--max-rmse", compare.max_rmse, "fail above this RMSE (linear)");
    c->add_option("--max-relative-mse", compare.max_relative_mse, "fail above this relative MSE (linear)");
    c->callback([this] { action = [this] { return compare_command(compare); }; });
  }

  void add_compare_runs() {
    auto* c = app.add_subcommand("compare-runs",
                                 "what has changed between two runs of an experiment, beyond its uncertainty");
    c->add_option("before", compare_runs.before, "run folder or report.json")->required();
    c->add_option("after", compare_runs.after, "run folder or report.json")->required();
    c->add_option("--json", compare_runs.json_file,
                  "write the comparison as JSON (- is standard output, instead of the table)");
    c->add_option("--level", compare_runs.level, "chance of any false alarm in the whole comparison")
        ->check(CLI::Range(1e-9, 0.5))
        ->capture_default_str();
    c->add_flag("--gate", compare_runs.gate, "exit status 1 if something got worse");
    c->callback([this] { action = [this] { return compare_runs_command(compare_runs); }; });
  }

  void add_plan_samples() {
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

  void add_gate() {
    auto* g = app.add_subcommand("gate", "evaluate gates on a stored report");
    g->add_option("report", gate.report, "report.json")->required();
    g->add_option("--gates", gate.gates, "gates file (default: the gates that the report was judged by)");
    g->add_option("--baseline", gate.baseline, "baseline to compare with");
    g->add_option("--junit", gate.junit, "write the results as JUnit XML");
    g->add_option("--markdown", gate.markdown, "write a short summary in Markdown, for a pull request");
    g->add_option("--write-baseline", gate.new_baseline, "store this report's numbers as a new baseline");
    g->callback([this] { action = [this] { return gate_command(gate); }; });
  }

  void add_report() {
    auto* r = app.add_subcommand("report", "draw the page of a stored run again");
    r->add_option("run", folder, "run folder, or the report.json or bench.json in it")->required();
    r->add_option("-o,--output", output, "file for the page (default: report.html or bench.html beside the report)");
    r->callback([this] { action = [this] { return report_command(folder, output); }; });
  }
};

/// One line, or more where the reason has more; names of files need not be text.
void print_error(const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", readable_lines(error.what()).c_str());
}

int run_action(int argc, char** argv) {
  CommandLine line;
  try {
    line.app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream help, complaint;
    const int code = line.app.exit(error, help, complaint);
    std::cout << help.str();
    std::cerr << readable_lines(complaint.str());
    return code == 0 ? passed : wrong_input;
  }
  try {
    std::unique_ptr<tbb::global_control> limit;
    if (line.common.threads > 0)
      limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                    static_cast<std::size_t>(line.common.threads));
    return line.action();
  } catch (const InputError& error) {
    print_error(error);
    return wrong_input;
  } catch (const std::exception& error) {
    print_error(error);
    return runtime_failure;
  }
}

}  // namespace

int run_command_line(int argc, char** argv) {
  prepare_standard_streams();
  const int status = run_action(argc, argv);
  try {
    finish_standard_output();
  } catch (const RuntimeFailure& error) {
    if (status == passed || status == failed) print_error(error);  // else the reason has been printed
    return status == wrong_input ? wrong_input : runtime_failure;
  }
  return status;
}

}  // namespace sturm
