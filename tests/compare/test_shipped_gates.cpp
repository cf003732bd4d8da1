#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "compare/gates.h"
#include "compare/healthy_report.h"

/// Every gate of the shipped files (those of validation.json and conoid_accuracy.json have tests of their own) passes a report whose number
/// is just inside of its bound, and rejects one whose number is just outside.
namespace sturm {
namespace {

using Place = std::function<void(Json& report, double value)>;

void for_matrix_images(Json& report, const std::function<void(Json&)>& visit) {
  for (Json& image : report["images"])
    if (image["ray_model"] == "power_matrix") visit(image);
}

Place image(const std::function<void(Json&, double)>& set) {
  return [set](Json& report, double value) { for_matrix_images(report, [&](Json& entry) { set(entry, value); }); };
}

/// The numbers in a report that statistics with a name of their own are made of.
const std::map<std::string, Place> places = {
    {"matrix_vs_conoid_max_z",
     [](Json& report, double value) { report["ellipses"]["cases"][0]["rays"][0]["against_conoid"]["z_max"] = value; }},
    {"image_ssim_display_min", image([](Json& entry, double value) { entry["metrics"]["ssim_display"]["value"] = value; })},
    {"image_ssim_below_noise_floor_max", image([](Json& entry, double value) {
       entry["noise_floor"]["ssim_display"] = entry["metrics"]["ssim_display"]["value"].get<double>() + value;
     })},
    {"image_matrix_rmse_over_noise_floor_max",
     image([](Json& entry, double value) { entry["metrics"]["rmse_linear"] = value * entry["noise_floor"]["rmse_linear"].get<double>(); })},
    {"image_ssim_gain_of_matrix_over_sin2_min",
     [](Json& report, double value) {
       report["images"][1]["metrics"]["ssim_display"]["value"] =
           report["images"][0]["metrics"]["ssim_display"]["value"].get<double>() - value;
     }},
    {"image_sin2_rmse_over_noise_floor_min",
     [](Json& report, double value) {
       report["images"][1]["metrics"]["rmse_linear"] = value * report["images"][1]["noise_floor"]["rmse_linear"].get<double>();
     }},
    {"sampling_unbiased_max_z",
     [](Json& report, double value) {
       report["sampling_study"]["entries"] = {{{"ray_model", "power_matrix"}, {"sampling", "uniform_disk"}, {"z", -value}}};
     }},
    {"sampling_raw_polar_min_z",
     [](Json& report, double value) {
       report["sampling_study"]["entries"] = {{{"ray_model", "power_matrix"}, {"sampling", "uniform_polar"}, {"z", value}}};
     }},
    {"sin2_study/gallery_sin2_over_noise_min",
     [](Json& report, double value) {
       report["sin2_study"] = {
           {"checks", Json::object()},
           {"gallery", {{{"cylinder_D", -1}, {"models", {{{"model", "sin2_radial"}, {"total_variation_over_noise", value}}}}}}}};
     }},
    {"sin2_study/gallery_repaired_over_noise_max",
     [](Json& report, double value) {
       report["sin2_study"] = {
           {"checks", Json::object()},
           {"gallery", {{{"cylinder_D", -1}, {"models", {{{"model", "repaired"}, {"total_variation_over_noise", value}}}}}}}};
     }},
};

/// Puts `value` where `statistic` reads it.
void place(Json& report, const std::string& statistic, double value) {
  if (const auto found = places.find(statistic); found != places.end()) return found->second(report, value);
  const std::size_t first = statistic.find('/'), last = statistic.rfind('/');
  ASSERT_NE(first, std::string::npos) << "no place for " << statistic;
  const std::string family = statistic.substr(0, first), name = statistic.substr(first + 1);
  if (family == "sin2_study")
    report["sin2_study"]["checks"][name] = {{"value", value}, {"cases", 1}, {"worst_case", "by hand"}};
  else if (family == "must_fail")
    report["must_fail"] = {{{"id", name}, {"failed_as_it_must", true}, {"value", value}, {"bound", 1.0}}};
  else if (family == "agreement_ssim_display")
    report["agreement"] = {
        {{"id", statistic.substr(first + 1, last - first - 1)},
         {"predictions", {{{"kind", statistic.substr(last + 1)}, {"parts", {{{"ssim_display", {{"value", value}}}}}}}}}}};
  else if (family == "agreement_ssim_without_noise")
    report["agreement"] = {{{"id", statistic.substr(first + 1, last - first - 1)},
                            {"predictions", {{{"kind", statistic.substr(last + 1)}, {"similarity_loss", {{"method", 1.0 - value}}}}}}}};
  else if (family == "agreement_times_faster_min")
    report["agreement"] = {{{"id", "by hand"}, {"predictions", {{{"kind", name}, {"times_faster", value}}}}}};
  else
    FAIL() << "no place for " << statistic;
}

bool passes(const GateSpec& gate, double value) {
  Json report = testing::healthy_report();
  place(report, gate.statistic, value);
  return evaluate_gates(std::span(&gate, 1), report, nullptr)[0]["passed"].get<bool>();
}

class ShippedGates : public ::testing::TestWithParam<const char*> {};

TEST_P(ShippedGates, PassWithinTheirBoundsAndRejectBeyond) {
  const std::string file = std::string(STURM_SOURCE_DIR "/configs/gates/") + GetParam();
  for (const GateSpec& gate : read_gates(load_json(file), file)) {
    const double step = gate.bound != 0.0 ? 0.01 * std::abs(gate.bound) : 1e-3;
    const double outwards = gate.comparison == Comparison::AtMost ? step : -step;  // all others are lower bounds
    EXPECT_TRUE(passes(gate, gate.bound - outwards)) << gate.id;
    EXPECT_FALSE(passes(gate, gate.bound + outwards)) << gate.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, ShippedGates,
                         ::testing::Values("desk.json", "night.json", "street.json", "sin2_study.json", "seed_samplings.json",
                                           "image_agreement.json"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace sturm
