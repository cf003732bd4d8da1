#include "app/comparison.h"
#include "io/files/formatted_text.h"

namespace sturm {

namespace {

std::string number(const std::optional<double>& value) {
  return value ? formatted("%12.6g", *value) : "           –";
}

std::string noise_columns(const MetricResult& m) {
  if (!m.noise) return "";
  std::string text = "   noise " + number(m.noise->value);
  if (m.noise->z)
    text += formatted("  z %6.1f  ", *m.noise->z) + (*m.distinguishable ? "distinguishable" : "not distinguishable");
  return text;
}

std::string part_table(const Comparison& c, const PartResult& part, bool whole) {
  std::string text = whole ? "" : formatted("\n%s (%zu px)\n", part.name.c_str(), part.pixels);
  if (part.pixels == 0) return text + "  empty\n";
  for (std::size_t i = 0; i < part.metrics.size(); ++i) {
    const ImageMetric& metric = c.pictures.metrics[i];
    text += padded(metric.title, 38) + " " + number(part.metrics[i].value) + noise_columns(part.metrics[i]);
    if (const auto bound = c.bounds.find(metric.key); whole && bound != c.bounds.end())
      text += std::string("   ") + (metric.more_is_better ? "≥ " : "≤ ") + exact_number(bound->second) +
              (c.keeps_bound(metric.key) ? "  passed"
               : part.metrics[i].value   ? "  FAILED (" + exact_number(*part.metrics[i].value) + ")"
                                         : "  FAILED");
    text += "\n";
  }
  return text;
}

std::string edge_table(const EdgeComparison& edge) {
  std::string text = formatted("\nslanted edge, tilt %.2f° and %.2f°\ncycles/px    MTF test   reference\n",
                               edge.test.tilt_deg, edge.reference.tilt_deg);
  for (std::size_t i = 0; i < edge.test.mtf.size(); ++i)
    text += formatted("%9.2f %11.4f %11.4f\n", edge.test.frequencies[i], edge.test.mtf[i], edge.reference.mtf[i]);
  return text;
}

std::optional<double> value_of(const std::optional<WithError>& e) {
  return e ? std::optional(e->value) : std::nullopt;
}

std::string psf_table(const PsfComparison& c) {
  std::string text = "\npoint spread functions\n";
  const auto line = [&](const char* title, const std::optional<double>& a, const std::optional<double>& b) {
    text += padded(title, 38) + " " + number(a) + " " + number(b) + "\n";
  };
  line("radius of 50 % of the light [arcmin]", c.test.radius_50.value, c.reference.radius_50.value);
  line("radius of 80 % of the light [arcmin]", c.test.radius_80.value, c.reference.radius_80.value);
  for (std::size_t d = 0; d < report_directions_deg.size(); ++d)
    for (const std::size_t k : {std::size_t{0}, report_frequencies_cpd.size() - 1})
      line(formatted("MTF at %g cycles/deg along %g°", report_frequencies_cpd[k], report_directions_deg[d]).c_str(),
           value_of(c.test.mtf[d][k]), value_of(c.reference.mtf[d][k]));
  const auto single = [&](const char* title, double value) {
    text += padded(title, 38) + formatted(" %12.6g\n", value);
  };
  single("shift of the centroid [arcmin]", c.shift.norm());
  single("total variation", c.total_variation.value);
  single("sliced Wasserstein [arcmin]", c.sliced_wasserstein);
  single("largest difference of MTF", c.largest_mtf_difference);
  return text;
}

}  // namespace

std::string table_of(const Comparison& c) {
  std::string text;
  for (std::size_t i = 0; i < c.pictures.parts.size(); ++i) text += part_table(c, c.pictures.parts[i], i == 0);
  if (c.regions_note) text += "\n" + *c.regions_note + "\n";
  if (c.edge) text += edge_table(*c.edge);
  if (c.psf) text += psf_table(*c.psf);
  if (c.pictures.z_threshold)
    text += formatted("\ndistinguishable: z above %.2f, a false-alarm rate of %g over %zu tests\n",
                      *c.pictures.z_threshold, noise_family_level, c.pictures.tests);
  for (std::size_t i = 0; i < c.notes.size(); ++i) text += (i == 0 ? "\n" : "") + c.notes[i] + "\n";
  return text;
}

}  // namespace sturm
