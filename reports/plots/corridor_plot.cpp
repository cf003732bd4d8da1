#include "reports/plots/corridor_plot.h"

#include <algorithm>

#include "io/files/csv.h"
#include "io/files/formatted_text.h"
#include "reports/markup/pictures.h"
#include "reports/plots/plot_style.h"

namespace sturm {

namespace {

using Member = std::optional<double> CorridorPlace::*;

std::string rows_of(const CorridorProfile& profile, Member member) {
  std::string rows;
  for (const CorridorPlace& place : profile.places)
    rows += place.*member ? plain_number(*(place.*member), 8) + " " + plain_number(place.elevation_deg) + "\n" : "\n";
  return rows;
}

/// Between numbers of the axis below, so that they do not touch each other.
double tick_step(std::span<const CorridorProfile> profiles, Member member) {
  double least = 0.0, most = 0.0;
  for (const CorridorProfile& profile : profiles)
    for (const CorridorPlace& place : profile.places) {
      least = std::min(least, (place.*member).value_or(0.0));
      most = std::max(most, (place.*member).value_or(0.0));
    }
  return most > least ? round_length_above((most - least) / 5.0) : 1.0;
}

/// One panel with the same member of all lenses.
std::string panel(std::span<const CorridorProfile> profiles, Member member, const std::string& name,
                  const std::string& axis, bool with_names) {
  std::string blocks, curves;
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    const std::string block = name + std::to_string(i);
    blocks += data_block(block, rows_of(profiles[i], member));
    curves += (i ? ", $" : "$") + block + " with lines lw 2.2 lc rgb '" + plot_colour(i) + "' " +
              (with_names ? "title " + plot_string(profiles[i].name) : "notitle");
  }
  return blocks + "set xtics " + plain_number(tick_step(profiles, member)) + "\nset xlabel " + plot_string(axis) +
         "\nplot " + curves + "\n";
}

std::string csv_of(std::span<const CorridorProfile> profiles) {
  CsvWriter csv;
  for (const char* heading : {"lens", "elevation_deg", "azimuth_deg", "addition_D", "astigmatism_D", "width_deg"})
    csv.text(heading);
  csv.end_row();
  for (const CorridorProfile& profile : profiles)
    for (const CorridorPlace& place : profile.places) {
      csv.text(profile.name);
      csv.number(place.elevation_deg);
      for (const auto& number : {place.azimuth_deg, place.addition_D, place.astigmatism_D, place.width_deg})
        csv.number(number);
      csv.end_row();
    }
  return csv.table();
}

}  // namespace

Plot corridor_plot(std::span<const CorridorProfile> profiles) {
  std::string script = plot_axes;
  script +=
      "set grid xtics ytics lc rgb '#e4e4e4' lw 1 lt 1\nset ylabel 'gaze up [°]'\nset bmargin 7\n"
      "set key at screen 0.5,0.02 center bottom vertical Left reverse samplen 2 maxrows 2\nset multiplot layout 1,4\n";
  if (!profiles.empty() && !profiles[0].places.empty())
    script += "set yrange [" + plain_number(profiles[0].places.back().elevation_deg) + ":" +
              plain_number(profiles[0].places.front().elevation_deg) + "]\n";
  const double limit = profiles.empty() ? 0.5 : profiles[0].limit_D;
  script += panel(profiles, &CorridorPlace::addition_D, "addition", "mean power less the nominal [D]", true) +
            "unset ylabel\n" +
            panel(profiles, &CorridorPlace::astigmatism_D, "astigmatism", "cylinder of the error [D]", false) +
            panel(profiles, &CorridorPlace::width_deg, "width",
                  "width with less than " + plain_number(limit) + " D [°]", false) +
            panel(profiles, &CorridorPlace::azimuth_deg, "middle", "its line, gaze to the right [°]", false);
  return {script + "unset multiplot\n",
          {.id = "corridor", .label = "Power and width along the corridor", .width = 1120, .height = 430},
          csv_of(profiles)};
}

}  // namespace sturm
