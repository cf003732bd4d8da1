#include "experiments/stress/free_form.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "io/specs/spectacles_spec.h"
#include "lensmodel/units.h"

namespace sturm::stress {

namespace {

constexpr double front_radius_mm = 120.0;
constexpr double index = 1.6, thickness_mm = 3.0, diameter_mm = 60.0;

Json progressive(double sphere_D, double cylinder_D, double addition_D, double length_mm, const char* eye,
                 Json zone_width_mm, double knot_spacing_mm) {
  return {{"progressive",
           {{"prescription", {{"sphere_D", sphere_D}, {"cylinder_D", cylinder_D}, {"axis_deg", 35.0}}},
            {"addition_D", addition_D},
            {"corridor_length_mm", length_mm},
            {"eye", eye},
            {"zone_width_mm", std::move(zone_width_mm)},
            {"knot_spacing_mm", knot_spacing_mm},
            {"center_thickness_mm", thickness_mm},
            {"refractive_index", index},
            {"diameter_mm", diameter_mm}}}};
}

/// A sphere of radius R at the distance r from its axis [mm].
double cap(double r, double radius) {
  return r * r / (radius * (1.0 + std::sqrt(1.0 - r * r / (radius * radius))));
}

double oblique_torus(double x, double y) {
  const double s = 0.8 * x + 0.6 * y, g = 0.8 * y - 0.6 * x;  // sweep radius 90 mm along 3-4-5, generator 60 mm
  const double z0 = cap(g, 60.0), from_axis = 90.0 - z0;
  return 90.0 - std::sqrt(from_axis * from_axis - s * s);
}
double hollow_sphere(double x, double y) {
  return cap(std::hypot(x, y), -40.0);
}
double rippled(double x, double y) {
  return cap(std::hypot(x, y), 80.0) + 0.05 * std::sin(0.4 * x) * std::cos(0.3 * y + 0.5);
}

}  // namespace

FreeFormLenses::FreeFormLenses() {
  const auto add = [&](const Json& document) {
    const SpectaclesSpec spec =
        read_spectacles(document, {"", ""}, Eye());  // its prescription is stated: no eye is asked
    made_.push_back({document.dump(), spec.lens.value(), std::nullopt});
  };
  add(progressive(1.0, -0.75, 2.0, 18.0, "right", 10.0, 0.5));
  add(progressive(-4.0, -2.0, 2.5, 12.0, "left", 6.0, 1.0));
  add(progressive(3.0, 0.0, 1.0, 30.0, "right", nullptr, 1.0));
  add(progressive(0.0, 0.0, -1.5, 18.0, "left", 15.0, 1.5));
  add(progressive(2.0, 1.5, 0.0, 18.0, "right", 10.0, 2.5));  // a sphere
  add(progressive(-2.0, -3.0, 3.5, 8.0, "right", 4.0, 2.0));
  made_.push_back(with_table("oblique_torus", 16, 4.0, oblique_torus));
  made_.push_back(with_table("ends_before_the_rim", 15, 2.5, hollow_sphere));
  made_.push_back(with_table("rippled", 32, 2.0, rippled));
}

FreeFormLenses::Made FreeFormLenses::with_table(const char* name, int cells, double spacing_mm,
                                                double (*height_mm)(double, double)) {
  Made made;
  made.table = Table{std::string(name) + ".csv", "x_mm,y_mm,z_mm\n"};
  Eigen::MatrixXd heights(cells + 1, cells + 1);
  const double first_mm = -0.5 * cells * spacing_mm;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const double x = first_mm + i * spacing_mm, y = first_mm + j * spacing_mm, z = height_mm(x, y);
      char row[96];
      std::snprintf(row, sizeof row, "%.17g,%.17g,%.17g\n", x, y, z);
      made.table->text += row;
      heights(i, j) = metres_per_millimetre * z;
    }
  // As io/specs/sag_grid.cpp makes it, so that the table repeats the case to the last bit.
  const double first = metres_per_millimetre * first_mm, last = metres_per_millimetre * (first_mm + cells * spacing_mm);
  const KnotGrid grid{Eigen::Vector2d::Constant(first), Eigen::Vector2d::Constant((last - first) / cells), cells,
                      cells};
  const BSplineSurface surface = BSplineSurface::interpolating(grid, heights);
  made.lens.back = surface.raised(-surface.sag(0.0, 0.0).value().value);
  made.lens.front = SphereSurface{1.0 / (metres_per_millimetre * front_radius_mm)};
  made.lens.center_thickness_m = metres_per_millimetre * thickness_mm;
  made.lens.refractive_index = index;
  made.lens.diameter_m = metres_per_millimetre * diameter_mm;
  const Json document = {{"back", {{"type", "sag_grid"}, {"file", made.table->file}}},
                         {"front", {{"type", "sphere"}, {"radius_mm", front_radius_mm}}},
                         {"center_thickness_mm", thickness_mm},
                         {"refractive_index", index},
                         {"diameter_mm", diameter_mm}};
  made.document = document.dump();
  return made;
}

Json FreeFormLenses::document(int k, const Json& stands) const {
  Json document = Json::parse(made_.at(static_cast<std::size_t>(k)).document);
  Json& place = document.contains("progressive") ? document["progressive"] : document;
  place.update(stands);
  return document;
}

}  // namespace sturm::stress
