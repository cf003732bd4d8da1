#include <cmath>

#include "compare/studies/samplings/sampling_findings.h"
#include "compare/studies/stored_words.h"
#include "reports/markup/html_table.h"
#include "reports/markup/numbers.h"
#include "reports/markup/parts.h"
#include "reports/plots/figure.h"
#include "reports/sections/sections.h"

namespace sturm {

namespace {

Html relative_html(const std::optional<double>& value, const std::optional<double>& whole) {
  return value && whole && *whole > 0.0 ? number_html(*value / *whole, 3) : absent_html();
}

/// The root of the mean square bias with its sign: an estimate below zero means that none was seen.
std::optional<double> signed_root(const std::optional<double>& square) {
  return square ? std::optional(std::copysign(std::sqrt(std::abs(*square)), *square)) : std::nullopt;
}

Html table_of(const SamplingFindings& found) {
  HtmlTable table("Bias and noise of pupil samplings", "sortable",
                  {{"Configuration"_html, false},
                   {"Ray model"_html, false},
                   {"Sampling"_html, false},
                   {"Sampler"_html, false},
                   {"RMS pupil radius"_html},
                   {"Mean square bias"_html},
                   {"RMS bias"_html},
                   {"z"_html},
                   {"Noise"_html},
                   {"Time [s]"_html}});
  for (const SamplingEntry& entry : found.entries)
    table.add_row(
        {text_or_dash(entry.configuration),
         code_html(word_of(entry.ray_model)),
         code_html(word_of(entry.sampling)),
         text_or_dash(word_of(entry.sampler)),
         {number_html(entry.pupil_rms_ratio, 4), entry.pupil_rms_ratio},
         {measured_html(entry.mean_square_bias, entry.mean_square_bias_standard_error), entry.mean_square_bias},
         {relative_html(signed_root(entry.mean_square_bias), entry.mean_radiance), entry.mean_square_bias},
         {number_html(entry.z, 3), entry.z},
         {relative_html(entry.noise, entry.mean_radiance), entry.noise},
         {number_html(entry.seconds, 3), entry.seconds}});
  return table.html();
}

}  // namespace

Html sampling_section(const Json& report, const std::filesystem::path& run_folder) {
  const std::optional<SamplingFindings> found = sampling_findings(report);
  if (!found) return {};
  Html html =
      element("h2", "Spread of rays over the pupil"_html) +
      element("p",
              "One view of "_html + text_or_dash(found->conditions.scene) + ", pupil "_html +
                  exact_html(found->conditions.pupil_mm) + " mm, "_html + count_html(found->conditions.replicates) +
                  " independent pictures of "_html + count_html(found->conditions.samples_per_pixel) +
                  " samples per pixel each, against as many by the uniform disc. The mean square bias [radiance²] is "
                  "unbiased "
                  "itself, so it may come out negative; z compares it with the error that it has where there is no "
                  "bias. RMS bias "
                  "(with the sign of its square) and noise (RMS deviation of one picture) are relative to the mean "
                  "radiance. RMS "
                  "pupil radius: of the points, relative to a uniform disc's, from the sampling's closed form."_html);
  for (const Json& figure : figures_of(report, "sampling_study")) html += figure_html(figure, run_folder);
  return element("section", {{"id", "sampling_study"}}, html + table_of(*found));
}

}  // namespace sturm
