#include <algorithm>
#include <cmath>

#include "compare/findings/quantities.h"
#include "compare/studies/sin2/shown_checks.h"
#include "io/files/formatted_text.h"
#include "io/json/stored.h"

namespace sturm {

namespace {

using Quantities = std::map<std::string, Quantity>;
using Better = Quantity::Better;

/// Of numbers by quadrature, which have no noise, relative or of numbers below 1: the loosest bound that
/// configs/gates/sin2_study.json has on what is nothing but rounding, where a pole or a small difference of large
/// numbers costs digits.
constexpr double rounding = 1e-6;

/// So many standard errors of independent rays are taken for a bound on what the noise of as many low-discrepancy ones,
/// which scatter less, does to a radius; both reports have one, so independent rays would be 5.7 standard errors of the
/// difference apart.
constexpr double errors_of_a_bound = 4.0;

std::optional<double> degrees_of(std::optional<double> replicates) {
  return replicates && *replicates > 1.0 ? std::optional(*replicates - 1.0) : std::nullopt;
}

void add_agreement(const Json& report, Quantities& out) {
  for (const Json& entry : array_at(report, "agreement")) {
    const auto replicates = number_at(entry, "replicates"), degrees = degrees_of(replicates);
    add_noise_floor(entry, "prediction " + text_at(entry, "id") + ": ", replicates, out);
    for (const Json& prediction : array_at(entry, "predictions")) {
      // Of the times nothing says how far they scatter from run to run. There is none where the error is below the
      // reference's noise.
      out["prediction " + text_at(entry, "id") + ", " + text_at(prediction, "kind") + ": times faster"] = {
          .value = number_at(prediction, "times_faster"), .better = Better::More, .may_vanish = true};
      for (const Json& part : array_at(prediction, "parts")) {
        const std::string name = "prediction " + text_at(entry, "id") + ", " + text_at(prediction, "kind") + ", " +
                                 text_at(part, "name") + ": ";
        const auto add = [&](const char* key, const char* title, Better better) {
          if (number_at(part, std::string(key) + "/value"))
            out[name + title] = {.value = number_at(part, std::string(key) + "/value"),
                                 .standard_error = number_at(part, std::string(key) + "/uncertainty"),
                                 .degrees = degrees,
                                 .better = better};
        };
        add("ssim_display", "SSIM", Better::More);
        // Not its root: near zero that is neither unbiased nor has it an error that says much.
        add("mean_square_display", "mean square error", Better::Less);
      }
    }
  }
}

void add_sampling_study(const Json& report, Quantities& out) {
  const auto degrees = degrees_of(number_at(report, "sampling_study/conditions/replicates"));
  for (const Json& entry : array_at(report, "sampling_study/entries")) {
    const std::string sampling = text_at(entry, "sampling");
    const std::string name =
        "sampling " + text_at(entry, "configuration") + ", " + sampling + ", " + text_at(entry, "sampler") + ": ";
    // The others are biased by design: another bias is neither better nor worse.
    const bool unbiased =
        text_at(entry, "ray_model") == "pinhole" || sampling == "uniform_disk" || sampling == "uniform_polar_weighted";
    out[name + "mean square bias [radiance²]"] = {.value = number_at(entry, "mean_square_bias"),
                                                  .standard_error = number_at(entry, "mean_square_bias_standard_error"),
                                                  .degrees = degrees,
                                                  .better = unbiased ? Better::Nearer : Better::Unknown,
                                                  .target = 0.0};
    out[name + "noise [radiance]"] = {.value = number_at(entry, "noise"),
                                      .standard_error = number_at(entry, "noise_standard_error"),
                                      .degrees = degrees,
                                      .better = Better::Less};
  }
}

/// A number by quadrature: nothing but rounding may change it.
Quantity exact(std::optional<double> value, Better better) {
  return {.value = value, .bound = rounding * std::max(1.0, std::abs(value.value_or(0.0))), .better = better};
}

void add_sin2_study(const Json& report, Quantities& out) {
  for (const ShownCheck& check : shown_checks) {
    const auto value = number_at(report, std::string("sin2_study/checks/") + check.key + "/value");
    out[std::string("sin² study, ") + check.key] = exact(value, check.deviation ? Better::Less : Better::Unknown);
  }
  for (const Json& model : array_at(report, "sin2_study/models"))
    for (const char* key : {"cases", "undefined", "pole", "rays_dropped", "largest_error_D"})
      out["sin² study, " + text_at(model, "ray_model") + ": " + key] = exact(number_at(model, key), Better::Unknown);
  for (const Json& row : array_at(report, "sin2_study/population")) {
    const auto metres = number_at(row, "distance_m");
    const std::string view = value_at(row, "accommodation").is_null()
                                 ? "worst view"
                                 : text_at(row, "accommodation") + ", " +
                                       (metres ? plain_number(*metres) + " m" : text_at(row, "distance_m"));
    const std::string name = "sin² study, real eyes, " + text_at(row, "ray_model") + ", " + view + ": ";
    for (const char* key : {"eyes", "pole", "noticeable", "error_D/median", "error_D/p90", "error_D/max"})
      out[name + key] = exact(number_at(row, key), Better::Unknown);
  }
  for (const Json& view : array_at(report, "sin2_study/gallery"))
    for (const Json& psf : array_at(view, "models")) {
      const std::string name = "sin² study, point spread " + text_at(view, "id") + ", " + text_at(psf, "model") + ": ";
      for (const char* radius : {"radius_50", "radius_80"}) {
        const auto error = number_at(psf, std::string(radius) + "_error_of_independent_rays_arcmin");
        out[name + radius + " [arcmin]"] = {.value = number_at(psf, std::string(radius) + "_arcmin"),
                                            .bound = error ? std::optional(errors_of_a_bound * *error) : std::nullopt};
      }
      if (text_at(psf, "model") == "wavefront") continue;
      // Both patterns are of random rays: by the triangle inequality their distance is off by no more than the distance
      // of two runs of the model and that of two runs of theory, half of it in each of the reports that are compared.
      out[name + "total variation from theory"] = {.value = number_at(psf, "total_variation"),
                                                   .bound = number_at(view, "noise_total_variation")};
    }
}

}  // namespace

void add_study_quantities(const Json& report, std::map<std::string, Quantity>& out) {
  add_agreement(report, out);
  add_sampling_study(report, out);
  add_sin2_study(report, out);
}

}  // namespace sturm
