#include "experiments/figures/figures.h"

#include "conoid/tracing/spectacle_conoid.h"
#include "experiments/figures/blur_field_layers.h"
#include "experiments/figures/lens_maps.h"
#include "io/files/error.h"
#include "io/files/text_file.h"
#include "lensmodel/gaze.h"
#include "reports/plots/lens_map.h"
#include "reports/plots/sturm_conoid_svg.h"
#include "stages/blur_field_stage.h"

namespace sturm {

namespace {

/// Draws one figure; each kind its own way.
struct Draw {
  const FigureSpec& spec;

  std::string operator()(const FigureFile& given) const {
    const auto svg = file_contents(given.file);
    if (!svg || !is_svg_file(*svg)) throw InputError(given.file.string(), "", "", "an SVG file");
    return *svg;
  }

  std::string operator()(const EllipseLayersFigure& layers) const {
    return layers_svg(layers.field, field_directions(layers.field));
  }

  std::string operator()(const SturmConoidFigure& c) const {
    const Eigen::Vector3d gaze = gaze_direction(c.azimuth, c.elevation);
    const Eigen::Matrix2d slopes = c.eye.slope_matrix(c.eye.accommodation_for(0.0)).matrix();
    SturmConoid drawing{Eigen::Matrix2d::Identity(), slopes, c.eye.pupil_radius_m, c.end_m};
    if (c.spectacles) {
      const SpectacleConoid conoid = trace_conoid(*c.spectacles, gaze, c.eye.rotation_center_m);
      if (conoid.status != LensStatus::ok)
        throw InputError("", "figure " + spec.id, "a line of sight that the lens stops", "one that comes through");
      drawing.offset = conoid.exit.offsets(slopes);
      drawing.slope = conoid.exit.slopes(slopes);
    }
    return sturm_conoid_svg(drawing, spec.title);
  }

  std::string operator()(const LensMapsFigure& maps) const {
    return lens_map_svg_file(
        as_worn_maps(*maps.lens.lens, nominal_power(maps.lens, {"", "figure " + spec.id}), maps.rotation_center_m));
  }

  std::string operator()(const DefocusMapsFigure& maps) const {
    std::vector<LensMap> drawn;
    for (std::size_t i = 0; i < maps.lenses.size(); ++i) {
      const Spectacles& lens = *maps.lenses[i].lens;
      const PowerMatrix correction =
          nominal_power(maps.lenses[i], {"", "figure " + spec.id}).moved_towards_eye(lens.vertex_distance_m);
      drawn.push_back(defocus_map(lens, correction, maps.rotation_center_m, maps.distance_m, maps.amplitude_D));
      drawn.back().title = maps.names[i] + "\\n" + drawn.back().title;
    }
    return lens_map_svg_file(drawn);
  }
};

}  // namespace

std::vector<Figure> drawn_figures(const std::vector<FigureSpec>& specs) {
  std::vector<Figure> figures;
  for (const FigureSpec& spec : specs)
    figures.push_back({spec.id, "", spec.title, spec.caption, spec.command, std::visit(Draw{spec}, spec.drawing)});
  return figures;
}

}  // namespace sturm
