#pragma once
#include <nlohmann/json.hpp>

/// Sections of studies in a report, with numbers made by hand; tests change one thing at a time.
namespace sturm::testing {

/// One view with one prediction, from `replicates` pictures of each kind.
inline nlohmann::json agreement_report(double ssim, double mean_square, int replicates = 1000000) {
  const nlohmann::json part = {{"name", "whole"},
                               {"pixels", 1024},
                               {"ssim_display", {{"value", ssim}, {"uncertainty", 0.003}}},
                               {"rmse_display", {{"value", 0.02}, {"uncertainty", 0.001}}},
                               {"mean_square_display", {{"value", mean_square}, {"uncertainty", 3e-5}}},
                               {"noise_display", 0.004},
                               {"share_of_squared_error", 1.0}};
  return {{"agreement",
           {{{"id", "box"},
             {"scene", "box.json"},
             {"gaze", "camera"},
             {"spectacles", false},
             {"replicates", replicates},
             {"noise_floor", {{"rmse_display", 0.01}}},
             {"noise_floor_uncertainty", nullptr},
             {"predictions", {{{"kind", "layered"}, {"seconds", {{"total", 1.0}}}, {"parts", {part}}}}}}}}};
}

/// One configuration by three samplings, eight pictures each; `z` and `noise` are those of the weighted polar sampling.
inline nlohmann::json sampling_report(double square, double z, double noise) {
  nlohmann::json entries = nlohmann::json::array();
  const auto add = [&](const char* sampling, double bias, double t, double deviation) {
    entries.push_back({{"configuration", "lens"},
                       {"ray_model", "thin_lens"},
                       {"sampling", sampling},
                       {"sampler", "halton"},
                       {"mean_radiance", 0.5},
                       {"noise", deviation},
                       {"noise_standard_error", 0.001},
                       {"mean_square_bias", bias},
                       {"mean_square_bias_standard_error", 2e-6},
                       {"z", t}});
  };
  add("uniform_disk", 1e-7, 0.4, 0.1);
  add("uniform_polar", 4e-4, 60.0, 0.1);
  add("uniform_polar_weighted", square, z, noise);
  return {{"sampling_study", {{"conditions", {{"replicates", 8}}}, {"entries", entries}}}};
}

/// One check that is a deviation, one model, one row of the population and one view of the gallery.
inline nlohmann::json sin2_report(double deviation, double total_variation) {
  return {{"sin2_study",
           {{"checks",
             {{"matrix_vs_theory_max",
               {{"value", deviation}, {"cases", 12}, {"worst_case", "A|1 m|4 mm|relaxed|power_matrix"}}}}},
            {"models", {{{"ray_model", "sin2_radial"}, {"cases", 12}, {"largest_error_D", 1.25}}}},
            {"population",
             {{{"ray_model", "sin2_radial"},
               {"accommodation", "relaxed"},
               {"distance_m", 1.0},
               {"eyes", 400},
               {"pole", 0},
               {"noticeable", 120},
               {"error_D", {{"median", 0.2}, {"p90", 0.5}, {"max", 1.25}}}}}},
            {"gallery",
             {{{"id", "circle"},
               {"noise_total_variation", 0.004},
               {"models",
                {{{"model", "wavefront"}, {"total_variation", 0.0}, {"total_variation_over_noise", 0.0}},
                 {{"model", "repaired"},
                  {"total_variation", total_variation},
                  {"total_variation_over_noise", total_variation / 0.004}}}}}}}}}};
}

}  // namespace sturm::testing
