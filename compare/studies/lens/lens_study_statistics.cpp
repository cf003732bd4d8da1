#include "compare/studies/lens/lens_study_statistics.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "io/files/formatted_text.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

Number distance_from(const Number& value, double expected) {
  return value ? Number(std::abs(*value - expected)) : std::nullopt;
}

void add_orders(const Json& section, Statistics& out) {
  Extreme order, relative, limit, spline(Extreme::Of::Smallest);
  const std::set<std::string> splines = spline_lenses(section);
  for (const Json& view : array_at(section, "views")) {
    const std::string name = view_name(view);
    const bool oblique = number_at(view, "eccentricity_deg").value_or(1.0) > 0.0,
               blurred = number_at(view, "blur_D/0").value_or(1.0) >= least_blur_D;
    if (splines.contains(text_at(view, "lens"))) {
      if (oblique && blurred) spline.add(number_at(view, "relative_order"), name);
      continue;
    }
    if (oblique) order.add(distance_from(number_at(view, "order"), 4.0), name);
    if (oblique && blurred) relative.add(distance_from(number_at(view, "relative_order"), 2.0), name);
    if (blurred) limit.add(number_at(view, "limit_relative"), name);
  }
  out["lens_order_max_deviation"] = order.result();
  out["lens_relative_order_max_deviation"] = relative.result();
  out["lens_limit_max_relative"] = limit.result();
  out["lens_spline_relative_order_min"] = spline.result();
}

/// The largest first-order error of a method in the views of one lens; views where it has none are left out: they are
/// counted elsewhere.
Extreme largest_first_order_error(const Json& views, const std::string& lens, const std::string& method) {
  Extreme largest;
  for (const Json& view : views)
    if (text_at(view, "lens") == lens)
      if (const Number error = number_at(view, "first_order/" + method + "/defocus_D"))
        largest.add(error, view_name(view));
  return largest;
}

void add_methods(const Json& section, Statistics& out) {
  Extreme revolution, unscaled, published(Extreme::Of::Smallest), previous(Extreme::Of::Smallest);
  const Json& views = array_at(section, "views");
  for (const Json& lens : array_at(section, "lenses")) {
    const std::string id = text_at(lens, "id");
    const bool round_lens = boolean_at(lens, "lens_of_revolution").value_or(false);
    const bool round_eye = number_at(lens, "cylinder_D").value_or(1.0) == 0.0;
    for (const Json& view : views) {
      if (text_at(view, "lens") != id) continue;
      const bool on_axis = number_at(view, "eccentricity_deg").value_or(1.0) == 0.0;
      if (round_lens && (on_axis || round_eye))
        revolution.add(number_at(view, "first_order/published/defocus_D"), view_name(view));
      unscaled.add(number_at(view, "previous_unscaled_error"), view_name(view));
    }
    if (!round_eye) published.add(largest_first_order_error(views, id, "published").result().value, id);
    previous.add(largest_first_order_error(views, id, "previous").result().value, id);
  }
  out["lens_published_revolution_max_D"] = revolution.result();
  out["lens_published_min_of_largest_D"] = published.result();
  out["lens_previous_unscaled_max"] = unscaled.result();
  out["lens_previous_min_of_largest_D"] = previous.result();
}

}  // namespace

std::set<std::string> spline_lenses(const Json& section) {
  std::set<std::string> ids;
  for (const Json& lens : array_at(section, "lenses"))
    if (!boolean_at(lens, "analytic_surfaces").value_or(true)) ids.insert(text_at(lens, "id"));
  return ids;
}

std::string view_name(const Json& view) {
  const auto number = [&](const char* path) {
    const Number value = number_at(view, path);
    return value ? plain_number(*value) : std::string("–");
  };
  std::string name = text_at(view, "lens") + "|" + number("eccentricity_deg") + "°";
  if (number_at(view, "direction_deg")) name += " " + number("direction_deg") + "°";
  return name + "|" + (value_at(view, "distance_m") == "inf" ? "inf" : number("distance_m") + " m");
}

void add_lens_study(const Json& report, Statistics& out) {
  add_orders(value_at(report, "lens_study"), out);
  add_methods(value_at(report, "lens_study"), out);
}

}  // namespace sturm
