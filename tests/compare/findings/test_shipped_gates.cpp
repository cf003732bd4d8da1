#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "compare/findings/healthy_report.h"
#include "compare/findings/judged_report.h"
#include "compare/findings/placed_statistics.h"
#include "support/source_folder.h"

/// Every gate of every file in configs/gates passes a report whose number is just inside of its bound, and rejects one
/// whose number is just outside. The files are read when the test runs: a new one is tested without anyone naming it
/// here.
namespace sturm {
namespace {

std::vector<std::filesystem::path> shipped_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(STURM_SOURCE_DIR "/configs/gates"))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  return files;
}

bool passes(const GateSpec& gate, const Json& report) {
  const Json baseline = testing::healthy_report();
  return evaluate_gates(std::span(&gate, 1), report, &baseline)[0].has_passed();
}

/// A report in which what the gate looks at has this value.
std::optional<Json> report_for(const GateSpec& gate, double value) {
  if (gate.kind != GateKind::Baseline) return testing::report_with(gate.statistic, value);
  if (gate.statistic != "image_ssim_display/*" || gate.unit != "σ") return std::nullopt;
  return testing::with_fallen_images(value);
}

TEST(ShippedGates, PassWithinTheirBoundsAndRejectBeyond) {
  EXPECT_THAT(shipped_files(), ::testing::Not(::testing::IsEmpty()));
  for (const std::filesystem::path& file : shipped_files())
    for (const GateSpec& gate : read_gates(load_json(file), file.string())) {
      SCOPED_TRACE(file.filename().string() + ", " + gate.id + ": " + gate.statistic);
      const double step = gate.bound != 0.0 ? 0.01 * std::abs(gate.bound) : 1e-3;
      const bool upper = gate.kind == GateKind::AtMost || gate.kind == GateKind::Baseline;
      const double outwards = upper ? step : -step;
      const std::optional<Json> inside = report_for(gate, gate.bound - outwards),
                                outside = report_for(gate, gate.bound + outwards);
      ASSERT_TRUE(inside && outside) << "nobody knows where this statistic's number stands in a report";
      EXPECT_TRUE(passes(gate, *inside));
      EXPECT_FALSE(passes(gate, *outside));
    }
}

TEST(ShippedGates, AStatisticThatNobodyPlacesIsNoticed) {
  EXPECT_FALSE(testing::report_with("no_such_thing", 1.0));
  EXPECT_FALSE(testing::report_with("no_such_family/name", 1.0));
  EXPECT_FALSE(testing::report_with("bench/view/method/no_such_kind/rmse", 1.0));
}

}  // namespace
}  // namespace sturm
