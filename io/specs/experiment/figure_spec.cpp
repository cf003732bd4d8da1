#include "io/specs/experiment/figure_spec.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/json/named_file.h"
#include "io/specs/worn_eye_spec.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr const char* kinds[] = {"file", "ellipse_layers", "sturm_conoid", "lens_maps", "defocus_maps"};

class FigureReader {
 public:
  FigureReader(const Json& value, const Source& where, FigureSpec& spec) : value_(value), where_(where), spec_(spec) {}

  void read() {
    std::vector<std::string> given;
    for (const char* kind : kinds)
      if (value_.contains(kind)) given.emplace_back(kind);
    if (given.size() != 1)
      where_.fail(value_,
                  "exactly one of \"file\", \"ellipse_layers\", \"sturm_conoid\", \"lens_maps\" and \"defocus_maps\"");
    const Json& drawing = value_[given[0]];
    const Source place = where_ / given[0];
    if (given[0] == "file")
      read_file(drawing, place);
    else if (given[0] == "ellipse_layers")
      read_layers(drawing, place);
    else if (given[0] == "sturm_conoid")
      read_conoid(drawing, place);
    else if (given[0] == "lens_maps")
      spec_.drawing = LensMapsFigure{read_lens(drawing["lens"], place / "lens"), rotation_center(drawing)};
    else
      read_defocus(drawing, place);
  }

 private:
  static double rotation_center(const Json& drawing) {
    const auto stated = drawing.find("rotation_center_mm");
    return stated == drawing.end() ? mean_rotation_center_m : metres_per_millimetre * stated->get<double>();
  }

  void add_inputs(const std::vector<std::string>& files) {
    spec_.input_files.insert(spec_.input_files.end(), files.begin(), files.end());
  }

  void read_file(const Json& drawing, const Source& place) {
    FigureFile figure{existing_file(drawing, place, "the path of an SVG file")};
    add_inputs({figure.file.string()});
    spec_.drawing = std::move(figure);
  }

  void read_layers(const Json& drawing, const Source& place) {
    const std::filesystem::path file = existing_file(drawing, place, "the path of a blur field document");
    EllipseLayersFigure figure{read_blur_field_spec(load_json(file.string()), file.string())};
    add_inputs({file.string()});
    add_inputs(figure.field.input_files);
    spec_.drawing = std::move(figure);
  }

  void read_conoid(const Json& drawing, const Source& place) {
    SturmConoidFigure figure;
    WornEyeSpec read = read_worn_eye(drawing, place);
    figure.eye = read.worn.eye;
    figure.spectacles = std::move(read.worn.spectacles);
    add_inputs(read.input_files);
    if (const auto gaze = drawing.find("gaze_deg"); gaze != drawing.end()) {
      figure.azimuth = radians_per_degree * (*gaze)[0].get<double>();
      figure.elevation = radians_per_degree * (*gaze)[1].get<double>();
    }
    figure.end_m = drawing["to_m"].get<double>();
    spec_.drawing = std::move(figure);
  }

  SpectaclesSpec read_lens(const Json& lens, const Source& place) {
    SpectaclesSpec spectacles = read_lens_alone(lens, place);
    add_inputs(spectacles.input_files);
    return spectacles;
  }

  void read_defocus(const Json& drawing, const Source& place) {
    DefocusMapsFigure figure;
    for (std::size_t i = 0; i < drawing["lenses"].size(); ++i) {
      const Json& lens = drawing["lenses"][i];
      figure.lenses.push_back(read_lens(lens, place / "lenses" / i));
      std::string name = lens.is_string() ? std::filesystem::path(lens.get<std::string>()).stem().string()
                                          : "lens " + std::to_string(i + 1);
      std::replace(name.begin(), name.end(), '_', ' ');
      figure.names.push_back(std::move(name));
    }
    figure.rotation_center_m = rotation_center(drawing);
    figure.distance_m = read_distance(drawing["distance_m"], place / "distance_m");
    figure.amplitude_D = drawing.value("amplitude_D", 0.0);
    spec_.drawing = std::move(figure);
  }

  const Json& value_;
  const Source& where_;
  FigureSpec& spec_;
};

}  // namespace

FigureSpec read_figure(const Json& value, const Source& where) {
  FigureSpec spec;
  spec.id = value["id"].get<std::string>();
  for (const char* own :
       {"bench_", "depth_psf_study_", "design_study_", "lens_study_", "sampling_study_", "sin2_study_"})
    if (spec.id.starts_with(own))
      (where / "id")
          .fail(value["id"], std::string("an id that does not start with \"") + own + "\": those are the run's own");
  spec.title = value["title"].get<std::string>();
  spec.caption = value.value("caption", "");
  spec.command = value.value("command", "");
  FigureReader(value, where, spec).read();
  return spec;
}

}  // namespace sturm
