#include "compare/findings/placed_statistics.h"

#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "compare/findings/healthy_report.h"
#include "compare/studies/lens/synthetic_lens_study.h"

namespace sturm::testing {

namespace {

using Place = std::function<void(Json& report, double value)>;

/// Puts the number itself at a JSON pointer.
Place at(const char* pointer) {
  return [pointer](Json& report, double value) { report.at(Json::json_pointer(pointer)) = value; };
}

/// Puts factor × number + offset there.
Place at(const char* pointer, double offset, double factor) {
  return [=](Json& report, double value) { report.at(Json::json_pointer(pointer)) = offset + factor * value; };
}

/// In a report with the section lens_study of two lenses and a spline.
Place in_lens_study(const Place& place) {
  return [place](Json& report, double value) {
    report["lens_study"] = sturm::test::synthetic_lens_study();
    place(report, value);
  };
}

Place all_of(std::vector<Place> places) {
  return [places = std::move(places)](Json& report, double value) {
    for (const Place& place : places) place(report, value);
  };
}

/// Of every image by wavefront theory.
Place image(const std::function<void(Json&, double)>& set) {
  return [set](Json& report, double value) {
    for (Json& entry : report["images"])
      if (entry["ray_model"] == "power_matrix") set(entry, value);
  };
}

/// A spot that lies along its predicted axes, with pixels so small that the grid adds nothing to the error of an axis.
Place spot(const Place& place) {
  return [place](Json& report, double value) {
    Json& entry = report["psfs"][0];
    entry["pixel_arcmin"] = 1e-9;
    entry["measured"]["orientation_deg"] = entry["predicted"]["orientation_deg"];
    entry["measured"]["semi_axes_arcmin"] = entry["predicted"]["semi_axes_arcmin"];
    place(report, value);
  };
}

Place in_gallery(const char* model) {
  return [model](Json& report, double value) {
    report["sin2_study"] = {
        {"checks", Json::object()},
        {"gallery", {{{"cylinder_D", -1}, {"models", {{{"model", model}, {"total_variation_over_noise", value}}}}}}}};
  };
}

/// One wearer of one design.
Place in_design_study(const std::string& pointer) {
  return [pointer](Json& report, double value) {
    report["design_study"] = {{"conditions", Json::object()},
                              {"designs", {{{"id", "one"}, {"largest_cylinder_D", 1.0}}}},
                              {"wearers", {{{"wearer", "P1-OD"}, {"design", "one"}, {"status", "ok"}}}}};
    report["design_study"][Json::json_pointer(pointer)] = value;
  };
}

Place of_sampling(const char* sampling, double sign) {
  return [=](Json& report, double value) {
    report["sampling_study"]["entries"] = {
        {{"ray_model", "power_matrix"}, {"sampling", sampling}, {"z", sign * value}}};
  };
}

// Of V = diag(2, 1) D: √((4 − 25/8)² + (1 − 13/8)²)/√(4² + 1²), what sin² differs by in the healthy report's cases with
// a cylinder.
const double predicted_sin2_difference = std::hypot(0.875, 0.625) / std::sqrt(17.0);

/// The numbers in a report that statistics with a name of their own are made of.
const std::map<std::string, Place>& places() {
  static const std::map<std::string, Place> known = {
      {"conoid_reference_max_relative_error", at("/reference/max_relative_error/conoid_covariance")},
      {"sin2_reference_max_relative_error", at("/reference/max_relative_error/sin2_closed_form")},
      {"matrix_vs_conoid_max_z", at("/ellipses/cases/0/rays/0/against_conoid/z_max")},
      {"matrix_vs_conoid_max_relative", at("/ellipses/cases/0/rays/0/against_conoid/relative_frobenius")},
      {"thin_lens_vs_conoid_max_z", at("/ellipses/cases/2/rays/2/against_conoid/z_max")},
      {"sin2_vs_closed_form_max_z", at("/ellipses/cases/1/rays/1/against_closed_form/z_max")},
      {"sin2_vs_closed_form_max_relative", at("/ellipses/cases/1/rays/1/against_closed_form/relative_frobenius")},
      {"sin2_vs_conoid_min_z", at("/ellipses/cases/0/rays/1/against_conoid/z_max")},
      {"sin2_vs_conoid_min_relative_difference_ratio",
       at("/ellipses/cases/0/rays/1/against_conoid/relative_frobenius", 0.0, predicted_sin2_difference)},
      {"sin2_vs_conoid_max_relative_difference_ratio",
       at("/ellipses/cases/0/rays/1/against_conoid/relative_frobenius", 0.0, predicted_sin2_difference)},
      {"psf_matrix_axis_max_z", spot(at("/psfs/0/measured/semi_axes_arcmin/1", 6.0, -0.01))},
      {"psf_matrix_axis_max_relative", spot(at("/psfs/0/measured/semi_axes_arcmin/0", 12.0, 12.0))},
      {"psf_matrix_centroid_max_z", at("/psfs/0/measured/centroid_arcmin/1", 0.0, -0.02)},
      {"image_light_max_deviation", at("/images/0/metrics/light_ratio/value", 1.0, -1.0)},
      {"image_shift_max_px", all_of({at("/images/2/metrics/shift_x_px/value", 0.0, -0.6),
                                     at("/images/2/metrics/shift_y_px/value", 0.0, 0.8)})},
      {"image_ssim_display_min",
       image([](Json& entry, double value) { entry["metrics"]["ssim_display"]["value"] = value; })},
      {"image_ssim_below_noise_floor_max", image([](Json& entry, double value) {
         entry["noise_floor"]["ssim_display"] = entry["metrics"]["ssim_display"]["value"].get<double>() + value;
       })},
      {"image_matrix_rmse_over_noise_floor_max", image([](Json& entry, double value) {
         entry["metrics"]["rmse_linear"] = value * entry["noise_floor"]["rmse_linear"].get<double>();
       })},
      {"image_ssim_gain_of_matrix_over_sin2_min", at("/images/1/metrics/ssim_display/value", 0.97, -1.0)},
      {"image_sin2_rmse_over_noise_floor_min", at("/images/1/metrics/rmse_linear", 0.0, 0.02)},
      {"must_fail_min_value_over_bound", at("/must_fail/0/value", 0.0, 0.005)},
      {"mutation_min_gates",
       [](Json& report, double value) {
         report["gate_power"]["mutations"][0]["caught_by"] =
             Json(static_cast<std::size_t>(value), Json{{"gate", "by hand"}});
       }},
      {"lens_order_max_deviation", in_lens_study(at("/lens_study/views/1/order", 4.0, -1.0))},
      {"lens_relative_order_max_deviation", in_lens_study(at("/lens_study/views/3/relative_order", 2.0, -1.0))},
      {"lens_limit_max_relative", in_lens_study(at("/lens_study/views/0/limit_relative"))},
      {"lens_spline_relative_order_min", in_lens_study(at("/lens_study/views/4/relative_order"))},
      {"lens_published_min_of_largest_D", in_lens_study(at("/lens_study/views/1/first_order/published/defocus_D"))},
      {"lens_published_revolution_max_D", in_lens_study(at("/lens_study/views/3/first_order/published/defocus_D"))},
      {"lens_previous_unscaled_max", in_lens_study(at("/lens_study/views/2/previous_unscaled_error"))},
      {"lens_previous_min_of_largest_D",
       in_lens_study(all_of({at("/lens_study/views/2/first_order/previous/defocus_D"),
                             at("/lens_study/views/3/first_order/previous/defocus_D")}))},
      {"sampling_unbiased_max_z", of_sampling("uniform_disk", -1.0)},
      {"sampling_raw_polar_min_z", of_sampling("uniform_polar", 1.0)},
      {"design_max_median_share", in_design_study("/wearers/0/share_blurred")},
      {"design_max_cylinder", in_design_study("/designs/0/largest_cylinder_D")},
      {"sin2_study/gallery_sin2_over_noise_min", in_gallery("sin2_radial")},
      {"sin2_study/gallery_repaired_over_noise_max", in_gallery("repaired")},
  };
  return known;
}

/// What stands between the slashes of a statistic's name.
std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  for (std::size_t from = 0, to = 0; to != std::string::npos; from = to + 1) {
    to = name.find('/', from);
    parts.push_back(name.substr(from, to == std::string::npos ? to : to - from));
  }
  return parts;
}

/// "bench/VIEW/METHOD/KIND/ERROR".
bool place_in_bench(Json& report, const std::string& name, double value) {
  const std::vector<std::string> parts = parts_of(name);
  if (parts.size() != 4) return false;
  const Json number = {{"value", value}, {"standard_error", 0.01}};
  Json view = {{"id", parts[0]}, {"methods", Json::array()}, {"ratios", Json::array()}};
  if (parts[2] == "slope")
    view["methods"] = {{{"id", parts[1]}, {"slopes", {{parts[3], {{"slope", value}, {"standard_error", 0.01}}}}}}};
  else if (parts[2] == "last_slope") {  // 4 and 16 samples
    const auto point = [&](double samples) {
      return Json{{"samples", samples}, {"errors", {{parts[3], {{"value", std::pow(samples, value)}}}}}};
    };
    view["methods"] = {{{"id", parts[1]}, {"points", {point(4.0), point(16.0)}}}};
  } else if (parts[2] == "error_ratio" || parts[2] == "time_ratio")
    view["ratios"] = {{{"method", parts[1]}, {"error", parts[3]}, {parts[2], number}}};
  else
    return false;
  report["bench"]["views"] = Json::array({view});
  return true;
}

/// "map/LIGHT/PUPIL", "eyes/ID/QUANTITY" or "banding/WEIGHTS/PARTS/SPACING/QUANTITY".
bool place_in_depth_psf_study(Json& report, const std::string& name, double value) {
  const std::vector<std::string> parts = parts_of(name);
  Json& study = report["depth_psf_study"];
  if (parts.size() == 3 && parts[0] == "map")
    study["map"] = {{{"light", parts[1]}, {"pupil_mm", std::stod(parts[2])}, {"total_variation", value}}};
  else if (parts.size() == 3 && parts[2] == "median_D")
    study["eyes"] = {{{"id", parts[1]}, {"defocus_D", {0.0, value, 9.0}}}};
  else if (parts.size() == 3 && parts[2] == "share_above_step")
    study["eyes"] = {{{"id", parts[1]}, {"share_above_step", value}}};
  else if (parts.size() == 5 && parts[0] == "banding")
    study["banding"] = {{{"weights", parts[1]},
                         {"pupil_parts", std::stoi(parts[2])},
                         {"spacing_px", std::stod(parts[3])},
                         {parts[4] == "step" ? "largest_step" : "rmse", value}}};
  else
    return false;
  return true;
}

/// Statistics whose names are made of a family and of names in the report.
bool place_of_family(Json& report, const std::string& statistic, double value) {
  const std::size_t first = statistic.find('/'), last = statistic.rfind('/');
  if (first == std::string::npos) return false;
  const std::string family = statistic.substr(0, first), name = statistic.substr(first + 1);
  if (family == "bench") return place_in_bench(report, name, value);
  const auto agreement = [&](const Json& numbers) {
    Json prediction = {{"kind", statistic.substr(last + 1)}};
    prediction.update(numbers);
    report["agreement"] = {{{"id", first == last ? "by hand" : statistic.substr(first + 1, last - first - 1)},
                            {"predictions", Json::array({prediction})}}};
  };
  if (family == "depth_psf_study") return place_in_depth_psf_study(report, name, value);
  if (family == "sin2_study")
    report["sin2_study"]["checks"][name] = {{"value", value}, {"cases", 1}, {"worst_case", "by hand"}};
  else if (family == "must_fail")
    report["must_fail"] = {{{"id", name}, {"failed_as_it_must", true}, {"value", value}, {"bound", 1.0}}};
  else if (family == "agreement_ssim_display")
    agreement({{"parts", {{{"ssim_display", {{"value", value}}}}}}});
  else if (family == "agreement_ssim_without_noise")
    agreement({{"similarity_loss", {{"method", 1.0 - value}}}});
  else if (family == "agreement_times_faster" || family == "agreement_times_faster_min")
    agreement({{"times_faster", value}});
  else
    return false;
  return true;
}

}  // namespace

std::optional<Json> report_with(const std::string& statistic, double value) {
  Json report = healthy_report();
  if (const auto found = places().find(statistic); found != places().end())
    found->second(report, value);
  else if (!place_of_family(report, statistic, value))
    return std::nullopt;
  return report;
}

Json with_fallen_images(double standard_errors) {
  Json report = healthy_report();
  // 0.004 each, and no number of replicates: as good as known.
  report["images"][2]["metrics"]["ssim_display"]["value"] = 0.98 - standard_errors * std::hypot(0.004, 0.004);
  return report;
}

}  // namespace sturm::testing
