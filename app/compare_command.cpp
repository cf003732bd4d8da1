#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/image_files.h"
#include "app/json_values.h"
#include "compare/metrics/relative_mse.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/ssim.h"
#include "io/atomic_file.h"
#include "io/tone_map.h"

namespace sturm {

namespace {

struct Metric {
  const char* key;
  const char* title;
  double value;
  std::optional<double> bound;
  bool at_least;  // the bound is a lower one

  bool passed() const { return !bound || (at_least ? value >= *bound : value <= *bound); }
};

std::vector<Metric> measure(const CompareOptions& options) {
  const Image test = read_main_layer(options.test), reference = read_main_layer(options.reference);
  const Image shown = to_display(test, options.exposure), shown_reference = to_display(reference, options.exposure);
  const RelativeMse relative = relative_mse(test, reference);
  return {{"ssim_display", "SSIM, display space", ssim(shown, shown_reference).mean, options.min_ssim, true},
          {"psnr_display_dB", "PSNR, display space [dB]", psnr_dB(shown, shown_reference), options.min_psnr_dB, true},
          {"rmse_linear", "RMSE, linear", rmse(test, reference), options.max_rmse, false},
          {"relative_mse", "relative MSE, linear", relative.plain, options.max_relative_mse, false},
          {"relative_mse_trimmed", "relative MSE without the worst 0.1 %", relative.trimmed, std::nullopt, false}};
}

Json json_of(const std::vector<Metric>& metrics, bool passed) {
  Json values, bounds = Json::object();
  for (const Metric& m : metrics) {
    values[m.key] = number_or_null(m.value);  // PSNR of equal images is infinite
    if (m.bound) bounds[m.key] = *m.bound;
  }
  return {{"metrics", std::move(values)}, {"bounds", std::move(bounds)}, {"passed", passed}};
}

void print_table(const std::vector<Metric>& metrics) {
  for (const Metric& m : metrics) {
    std::printf("%-38s %12.6g", m.title, m.value);
    if (m.bound) std::printf("   %s %g  %s", m.at_least ? "≥" : "≤", *m.bound, m.passed() ? "passed" : "FAILED");
    std::printf("\n");
  }
}

}  // namespace

int compare_command(const CompareOptions& options) {
  const std::vector<Metric> metrics = measure(options);
  bool passed = true;
  for (const Metric& m : metrics) passed = passed && m.passed();
  const std::string text = json_of(metrics, passed).dump(1) + "\n";
  if (options.json_file == "-") {
    std::cout << text;
  } else {
    print_table(metrics);
    if (!options.json_file.empty()) write_file_atomically(options.json_file, text);
  }
  return passed ? 0 : 1;
}

}  // namespace sturm
