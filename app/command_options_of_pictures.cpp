#include "app/command_options.h"
#include "stages/see_stage.h"

namespace sturm {

void CommandLine::add_render() {
  auto* render = app.add_subcommand("render", "one image, path traced or predicted");
  add_documents(*render, common, "views (sturm.render/1)", "render")->required();
  add_run_options(*render, common);
  add_wearer(*render, common);
  add_spectacles(*render, common);
  render->add_option("--samples", preview.samples_per_pixel, "samples per pixel")->check(CLI::Range(1, 16777216));
  render->add_option("--size", preview.size, "WIDTHxHEIGHT of the picture [px]");
  auto* file_option =
      render->add_option("-o,--output", output,
                         "EXR file, with a PNG beside it, or PNG file alone; and a manifest. Of several views a "
                         "folder, or a name with {name}");
  render->add_option("--preview", preview.file, "PNG file that shows the picture while it grows");
  render->add_option("--preview-interval-s", preview.interval_s, "seconds between two previews, at least")
      ->check(CLI::Range(0.0, 86400.0))
      ->capture_default_str();
  render->add_flag("--explain", explain, "print what the picture does without, and why; nothing is rendered")
      ->excludes(file_option);
  render->callback([this, file_option] {
    if (!explain && !common.print_config && file_option->empty()) throw CLI::RequiredError("--output");
    action = [this] { return explain ? explain_command(common, preview) : render_command(common, preview, output); };
  });
}

void CommandLine::add_serve() {
  auto* s = app.add_subcommand("serve", "show a view in a browser, and render what its page shows");
  add_common_options(*s, common, "view (sturm.render/1)", "render");
  add_wearer(*s, common);
  add_spectacles(*s, common);
  s->add_option("--template", serve.page_template, "the page without data (default: the one that was built)");
  s->add_option("--port", serve.port, "on 127.0.0.1; 0 = any that is free")->check(CLI::Range(0, 65535));
  s->callback([this] { action = [this] { return serve_command(common, serve); }; });
}

void CommandLine::add_view() {
  auto* view = app.add_subcommand("view", "a view as a page that a browser shows, with its own optics");
  add_common_options(*view, common, "view (sturm.render/1)", "render");
  add_wearer(*view, common);
  add_spectacles(*view, common);
  auto* file_option = view->add_option("-o,--output", output, "HTML file");
  view->add_option("--template", page_template, "the page without data (default: the one that was built)");
  view->callback([this, file_option] {
    if (!common.print_config && file_option->empty()) throw CLI::RequiredError("--output");
    action = [this] { return view_command(common, page_template, output); };
  });
}

void CommandLine::add_see() {
  auto* s = app.add_subcommand("see", "any picture with a depth map, as an eye sees it");
  s->add_option("picture", see.picture,
                "sharp picture: EXR, HDR, PFM (linear), PNG, JPEG … (sRGB); or a document (sturm.see/1: X.json, or - "
                "for standard input)")
      ->required();
  know_shipped_names(*s->add_option("--eye", common.worn.eye, "eye (sturm.eye/1), or the name of a shipped one"),
                     "eyes");
  add_prescription(*s, common, "the eye");
  add_changes(*s, common, "see");
  auto* output_option = s->add_option("-o,--output", see.output, "PNG or EXR file; a manifest appears beside it");
  add_see_depth(*s);
  add_see_view(*s);
  s->add_flag("--explain", see.explain, "print what is done with each tile and layer; nothing is written")
      ->excludes(output_option);
  add_work_options(*s, common);
  s->callback([this, s, output_option] {
    see.disparity = s->count("--disparity") > 0;
    if (!see.explain && !common.print_config && output_option->empty()) throw CLI::RequiredError("--output");
    action = [this] { return see_command(common, see); };
  });
}

void CommandLine::add_see_depth(CLI::App& s) {
  auto* depth = s.add_option("--depth", see.depth, "depth map: EXR, PFM or 16-bit PNG (default: the picture's own Z)");
  s.add_option("--layer", see.layers,
               "surface that the picture hides or shows: EXR with R, G, B, Z and A; may be repeated")
      ->allow_extra_args(false);
  s.add_option("--picture-layer", see.picture_layer, "of EXR files with several pictures: the name of one");
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

void CommandLine::add_see_view(CLI::App& s) {
  auto* vfov = s.add_option("--vfov-deg", see.vfov_deg, "field of view from top to bottom [deg]");
  vfov->check(CLI::Range(1e-3, 175.0));
  s.add_option("--hfov-deg", see.hfov_deg, "or from left to right [deg]")
      ->check(CLI::Range(1e-3, 175.0))
      ->excludes(vfov);
  s.add_option("--pupil,--pupil-mm", common.worn.pupil_mm, "pupil diameter in place of the eye's own [mm]")
      ->check(CLI::Range(0.0, 100.0));
  auto* focus_m =
      s.add_option("--focus,--focus-m", common.worn.focus_m, "accommodation as a distance [m]; inf = relaxed");
  s.add_option("--focus-D", see.focus_D, "accommodation as a power [D]")
      ->check(CLI::Range(0.0, 1000.0))
      ->excludes(focus_m);
  auto* parts = s.add_option(
      "--parts", see.parts,
      "parts of the pupil that are composited on their own (default: " + std::to_string(usual_parts) + ")");
  parts->check(CLI::Range(1, 64));
  s.add_option("--error", see.error, "root-mean-square error beside edges that parts are chosen for")
      ->check(CLI::PositiveNumber)
      ->excludes(parts);
  s.add_option("--psf", see.psf, "rays (default), or waves (with diffraction, in one part)")
      ->check(CLI::IsMember({"rays", "waves"}));
  s.add_flag("--chromatic", see.chromatic, "red, green and blue are out of focus by different amounts");
  s.add_option("--exposure", see.exposure, "factor before the display transfer function of a PNG (default: 1)")
      ->check(CLI::PositiveNumber);
  s.add_option("--png-bits", see.png_bits, "8 (default) or 16 bits for each value of a PNG")
      ->check(CLI::IsMember({8, 16}));
  add_see_sequences(s);
}

void CommandLine::add_see_sequences(CLI::App& s) {
  auto* rack = s.add_option("--rack-focus-D", see.rack_focus_D, "FROM TO: frames with this accommodation [D]");
  rack->expected(2)->check(CLI::Range(0.0, 1000.0))->excludes("--focus-m")->excludes("--focus-D");
  s.add_option("--pupil-sequence-mm", see.pupil_sequence_mm, "FROM TO: frames with this pupil [mm]")
      ->expected(2)
      ->check(CLI::Range(0.0, 100.0))
      ->excludes("--pupil-mm");
  s.add_option("--frames", see.frames, "of a sequence (default: 25)")->check(CLI::Range(2, 100000));
  s.add_flag("--film", see.film, "join the frames of a sequence into X.mp4 (needs ffmpeg)");
}

void CommandLine::add_compare() {
  auto* c = app.add_subcommand("compare", "metrics of two pictures; bounds make it a gate");
  c->add_option("test", compare.test, "EXR, HDR, PFM, PNG, JPEG, TIFF, …");
  c->add_option("reference", compare.reference, "the same");
  add_compare_suite(*c);
  c->add_option("--layer", compare.layers,
                "layer of EXR files with several: once for both, or for the test and again for the reference")
      ->allow_extra_args(false);
  c->add_option("--json", compare.json_file, "write the metrics as JSON (- is standard output, instead of the table)");
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
  c->callback([this] {
    if (compare.suite.empty() && compare.reference.empty()) throw CLI::RequiredError("two pictures, or --suite");
    action = [this] { return compare.suite.empty() ? compare_command(compare) : compare_suite_command(compare); };
  });
}

void CommandLine::add_compare_suite(CLI::App& c) {
  auto* suite = c.add_option("--suite", compare.suite, "folder of pairs: NAME/test.EXT and NAME/reference.EXT");
  suite->excludes("test")->excludes("reference");
  c.add_flag("--beyond-noise", compare.beyond_noise, "pairs with test_seed.EXT fail where seeds do not explain it")
      ->needs(suite);
  c.add_option("--junit", compare.junit, "write what became of each pair as JUnit XML")->needs(suite);
  c.add_option("--markdown", compare.markdown, "write a short summary in Markdown, for a pull request")->needs(suite);
}

}  // namespace sturm
