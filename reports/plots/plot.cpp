#include "reports/plots/plot.h"

#include "io/files/plain_file.h"

namespace sturm {

bool is_picture_name(const std::string& name) {
  return has_suffix(name, ".svg") || has_suffix(name, ".png") || has_suffix(name, ".pdf");
}

std::string plot_file(const Plot& plot, const std::string& name) {
  if (has_suffix(name, ".png")) return gnuplot_png(plot.script, plot.frame);
  if (has_suffix(name, ".pdf")) return gnuplot_pdf(plot.script, plot.frame);
  return gnuplot_labelled_file(plot.script, plot.frame);
}

}  // namespace sturm
