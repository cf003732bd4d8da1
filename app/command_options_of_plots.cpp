#include "app/command_options.h"
#include "app/plot_kinds.h"

namespace sturm {

void CommandLine::add_plot() {
  auto* p = app.add_subcommand("plot", "figures of eyes and lenses with their numbers: SVG, PNG or PDF, and CSV");
  p->add_option("kind", plot.kind, "what is drawn")->required()->check(CLI::IsMember(plot_kind_words.all()));
  p->add_option("files", plot.files,
                "eyes, lenses (also shipped ones by name), or documents that have an eye; none: the eye of --rx");
  take_shipped_names(*p->get_option("files"), "eyes");
  take_shipped_names(*p->get_option("files"), "lenses");
  p->add_option("-o,--output", plot.output, "picture: .svg, .png or .pdf")->required();
  p->add_option("--csv", plot.csv, "file for its numbers (default: beside the picture)");
  p->add_option("--rx", plot.prescription, "prescription in optical notation: \"-2.00 -1.50 x 30\"");
  p->add_option("--lens", plot.spectacles,
                "spectacle lens that the eye looks through: a file, or the name of a shipped one");
  take_shipped_names(*p->get_option("--lens"), "lenses");
  p->add_option("--pupil", plot.worn.pupil_mm, "pupil diameter in place of the eye's own [mm] (default: 4)")
      ->check(CLI::Range(0.01, 100.0));
  auto* age =
      p->add_option("--age", plot.worn.age_years, "age of the eye, from which its accommodation follows [years]");
  age->check(CLI::Range(0.0, 150.0));
  p->add_option("--amplitude", plot.worn.amplitude_D, "or its amplitude of accommodation itself [D]")
      ->check(CLI::Range(0.0, 100.0))
      ->excludes(age);
  p->add_option("--distance", plot.distances_m, "of targets [m], with commas between; inf = far away")
      ->delimiter(',')
      ->allow_extra_args(false);
  p->add_option("--nearest-m", plot.nearest_m, "nearest target of a curve of blur")->check(CLI::Range(0.01, 10.0));
  p->add_option("--range", plot.range, "end of the scale: D, um or arcmin")->check(CLI::PositiveNumber);
  p->add_option("--clear-D", plot.clear_D, "defocus up to which vision counts as clear [D]")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  p->add_option("--psf", plot.psf, "of a modulation transfer: waves, rays or both")
      ->check(CLI::IsMember({"waves", "rays", "both"}))
      ->capture_default_str();
  p->add_flag("--difference", plot.difference, "of power: also what each further lens has more than the first");
  p->add_option("--rotation-center-mm", plot.rotation_center_mm, "of lenses: centre of rotation behind the pupil [mm]")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str();
  p->callback([this] { action = [this] { return plot_command(plot); }; });
}

void CommandLine::add_wearers() {
  auto* c =
      app.add_subcommand("wearers", "what each wearer of a table of prescriptions sees through lens designs: CSV");
  take_shipped_paths(*c->add_option("table", wearers.table, "prescriptions (CSV)")->required());
  c->add_option("lenses", wearers.lenses, "single-vision or progressive lenses, which are made for each wearer")
      ->required();
  take_shipped_names(*c->get_option("lenses"), "lenses");
  c->add_option("--distance", wearers.distances_m, "of targets [m], with commas between; inf = far away")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  auto* age = c->add_option("--age", wearers.age, "of all wearers, in place of the ages in the table [years]");
  age->check(CLI::Range(0.0, 150.0));
  c->add_option("--amplitude", wearers.amplitude_D, "or their amplitude of accommodation itself [D]")
      ->check(CLI::Range(0.0, 100.0))
      ->excludes(age);
  c->add_option("--clear-D", wearers.clear_D, "defocus up to which vision counts as clear [D]")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  c->add_option("--reach-deg", wearers.reach_deg, "gazes go so far in all directions [deg]")
      ->check(CLI::Range(0.0, 80.0))
      ->capture_default_str();
  c->add_option("--step-deg", wearers.step_deg, "from gaze to gaze [deg]")
      ->check(CLI::Range(0.5, 80.0))
      ->capture_default_str();
  c->add_option("--vertex", wearers.vertex_mm, "vertex distance of rows that state none [mm]")
      ->check(CLI::Range(0.0, 50.0))
      ->capture_default_str();
  c->add_option("-o,--output", wearers.output, "file instead of standard output");
  c->callback([this] { action = [this] { return wearers_command(wearers); }; });
}

void CommandLine::add_validate_camera() {
  ValidateCameraOptions& v = validate_camera;
  auto* c = app.add_subcommand("validate-camera", "scenes with known blur, and whether a renderer's picture has it");
  c->add_option("folder", v.folder, "of the scene, and of picture.exr")->required();
  auto* write = c->add_flag("--write", v.write, "write the scene instead of judging its picture");
  auto* eye = c->add_option("--eye", v.eye,
                            "eye that the camera has: a file or the name of a shipped one, instead of a thin lens");
  take_shipped_names(*eye, "eyes");
  eye->needs(write);
  c->add_option("--rx", v.prescription, "prescription of the camera's eye, for cameras with a cylinder")->needs(write);
  c->add_option("--pupil", v.pupil_mm, "diameter of its pupil [mm] (default: 6)")
      ->check(CLI::Range(0.01, 100.0))
      ->needs(write);
  c->add_option("--focus", v.focus_m, "distance that it is in focus at [m] (default: 1)")
      ->check(CLI::Range(0.05, 1e6))
      ->needs(write)
      ->excludes(eye);
  c->add_option("--picture", v.picture, "linear picture (default: picture.exr in the folder)")->excludes(write);
  c->add_option("--tolerance", v.relative, "of semi-axes, relative to the longer one")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  c->add_option("--tolerance-px", v.absolute_px, "of semi-axes, in addition [px]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  c->add_option("--centroid-px", v.centroid_px, "tolerance of centroids [px]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  c->add_option("--orientation-deg", v.orientation_deg, "tolerance of the long axis [deg]")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  c->add_option("--junit", v.junit, "write the results as JUnit XML")->excludes(write);
  c->add_option("--markdown", v.markdown, "write a short summary in Markdown")->excludes(write);
  c->callback([this] { action = [this] { return validate_camera_command(validate_camera); }; });
}

}  // namespace sturm
