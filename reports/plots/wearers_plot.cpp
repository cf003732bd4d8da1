#include "reports/plots/wearers_plot.h"

#include <algorithm>

#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "reports/plots/plot_style.h"

namespace sturm {

namespace {

constexpr int shares_width = 430;

/// Percent of the gazes, and percent of the wearers who have at most so many that are blurred.
std::string steps_of(std::vector<double> shares) {
  std::sort(shares.begin(), shares.end());
  std::string rows = "0 0\n";
  for (std::size_t i = 0; i < shares.size(); ++i)
    rows += plain_number(100.0 * shares[i], 6) + " " +
            plain_number(100.0 * static_cast<double>(i + 1) / static_cast<double>(shares.size()), 6) + "\n";
  return rows + "100 100\n";
}

std::string panel(const SharesAtDistance& at, std::size_t number) {
  std::string blocks, curves;
  for (std::size_t i = 0; i < at.designs.size(); ++i) {
    const std::string block = "shares" + std::to_string(number) + "_" + std::to_string(i);
    blocks += data_block(block, steps_of(at.designs[i].shares));
    curves += (i ? ", $" : "$") + block + " with steps lw 2.2 lc rgb '" + plot_colour(i) + "' " +
              (number == 0 ? "title " + plot_string(at.designs[i].name) : "notitle");
  }
  return blocks + "set title " + plot_string("target " + distance_words(at.distance_m)) + "\nplot " + curves + "\n";
}

std::string csv_of(std::span<const SharesAtDistance> distances) {
  CsvWriter csv;
  for (const char* heading : {"design", "distance_m", "share_blurred"}) csv.text(heading);
  csv.end_row();
  for (const SharesAtDistance& at : distances)
    for (const BlurredShares& design : at.designs)
      for (const double share : design.shares) {
        csv.text(design.name);
        csv.text(exact_number(at.distance_m));
        csv.number(share);
        csv.end_row();
      }
  return csv.table();
}

}  // namespace

Plot wearers_plot(std::span<const SharesAtDistance> distances, double clear_D) {
  std::string script = plot_axes;
  script += "set grid xtics ytics lc rgb '#e4e4e4' lw 1 lt 1\nset xrange [0:100]\nset yrange [0:100]\n" +
            ("set xlabel " + plot_string("gazes blurred by more than " + plain_number(clear_D) + " D [%]")) +
            "\nset ylabel 'wearers with at most so many [%]'\nset bmargin 7\n"
            "set key at screen 0.5,0.02 center bottom vertical Left reverse samplen 2 maxrows 2\n"
            "set multiplot layout 1," +
            std::to_string(distances.size()) + "\n";
  for (std::size_t i = 0; i < distances.size(); ++i) script += panel(distances[i], i);
  return {script + "unset multiplot\n",
          {.id = "wearers",
           .label = "How many wearers have how many blurred gazes",
           .width = shares_width * static_cast<int>(std::max<std::size_t>(1, distances.size())),
           .height = 430},
          csv_of(distances)};
}

}  // namespace sturm
