#include "experiments/figures/wearer_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/statistics/median.h"
#include "experiments/figures/defocus_as_worn.h"
#include "io/files/csv.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/specs/spectacles_spec.h"
#include "lensmodel/accommodation.h"
#include "lensmodel/gaze.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr double any_pupil_m = 4e-3;  // it has no part in a defocus

/// The design without a prescription of its own, so that it is made for the eye.
Json unmade(const TriedDesign& design) {
  Json document = design.document;
  for (const char* maker : {"single_vision", "progressive"})
    if (const auto made = document.find(maker); made != document.end() && made->is_object()) {
      made->erase("prescription");
      return document;
    }
  throw InputError(design.file, "", "a lens of given surfaces",
                   "a single_vision or progressive lens, which can be made for each wearer");
}

/// The design with the wearer's addition, if it has one and the table states it.
Json with_addition(Json document, const std::optional<double>& addition_D) {
  if (const auto made = document.find("progressive"); made != document.end() && addition_D)
    (*made)["addition_D"] = *addition_D;
  return document;
}

std::optional<double> addition_of(const Json& document) {
  const auto made = document.find("progressive");
  return made == document.end() ? std::nullopt : std::optional(made->value("addition_D", 0.0));
}

/// A design made for one wearer, or why it cannot be.
struct MadeLens {
  std::optional<Spectacles> lens;
  std::string not_made;
};

MadeLens made_for(const Eye& eye, const Json& design, const std::string& file) {
  try {
    return {read_spectacles(design, {file, ""}, eye).lens.value(), ""};
  } catch (const InputError& error) {
    return {std::nullopt, error.value()};
  }
}

/// A design that can be made for nobody is at fault itself.
void require_made(const std::vector<WearerRow>& rows, const TriedDesign& design, const Json& document,
                  const TabledPrescription& anybody) {
  const bool made = std::any_of(rows.begin(), rows.end(),
                                [&](const WearerRow& row) { return row.lens == design.name && row.not_made.empty(); });
  if (!made) read_spectacles(document, {design.file, ""}, Eye::with(anybody.prescription, any_pupil_m));
}

WearerRow looked_through(const Spectacles& lens, const PowerMatrix& correction, const WearerQuestion& question,
                         double distance_m, double amplitude_D) {
  WearerRow row;
  row.distance_m = distance_m;
  std::vector<double> blur;
  const int steps = static_cast<int>(std::floor(question.reach_deg / question.step_deg + 1e-9));
  for (int up = -steps; up <= steps; ++up)
    for (int right = -steps; right <= steps; ++right) {
      const double azimuth = question.step_deg * right, elevation = question.step_deg * up;
      if (std::hypot(azimuth, elevation) > question.reach_deg) continue;
      ++row.gazes;
      const auto defocus = defocus_as_worn(lens, correction,
                                           gaze_direction(radians_per_degree * azimuth, radians_per_degree * elevation),
                                           question.rotation_center_m, distance_m, amplitude_D);
      if (!defocus) {
        ++row.lost;
        continue;
      }
      if (blur.empty() || defocus->larger_D > row.largest_D) {
        row.largest_D = defocus->larger_D;
        row.largest_azimuth_deg = azimuth;
        row.largest_elevation_deg = elevation;
      }
      blur.push_back(defocus->larger_D);
    }
  if (blur.empty()) return row;
  const auto blurred = std::count_if(blur.begin(), blur.end(), [&](double D) { return D > question.clear_D; });
  row.share_blurred = static_cast<double>(blurred) / static_cast<double>(blur.size());
  row.median_D = *median(blur);
  return row;
}

}  // namespace

std::vector<WearerRow> wearer_table(const std::vector<TabledPrescription>& wearers,
                                    const std::vector<TriedDesign>& designs, const WearerQuestion& question) {
  std::vector<Json> documents;
  for (const TriedDesign& design : designs) documents.push_back(unmade(design));
  std::vector<std::vector<WearerRow>> rows(wearers.size());
  tbb::parallel_for(std::size_t{0}, wearers.size(), [&](std::size_t w) {
    const TabledPrescription& wearer = wearers[w];
    const Eye eye = Eye::with(wearer.prescription, any_pupil_m);
    const double of_age_D = wearer.age_years ? hofstetter_amplitude(*wearer.age_years) : 0.0,
                 amplitude_D = question.amplitude_D.value_or(of_age_D);
    for (std::size_t d = 0; d < designs.size(); ++d) {
      const Json design = with_addition(documents[d], wearer.addition_D);
      const MadeLens made = made_for(eye, design, designs[d].file);
      for (const double distance : question.distances_m) {
        WearerRow row =
            made.lens ? looked_through(*made.lens, eye.correction, question, distance, amplitude_D) : WearerRow{};
        row.distance_m = distance;
        row.not_made = made.not_made;
        row.wearer = wearer.id;
        row.lens = designs[d].name;
        row.prescription = wearer.prescription;
        row.age_years = wearer.age_years;
        row.addition_D = addition_of(design);
        row.amplitude_D = amplitude_D;
        rows[w].push_back(std::move(row));
      }
    }
  });
  std::vector<WearerRow> table;
  for (const std::vector<WearerRow>& some : rows) table.insert(table.end(), some.begin(), some.end());
  if (!table.empty())
    for (std::size_t d = 0; d < designs.size(); ++d) require_made(table, designs[d], documents[d], wearers.front());
  return table;
}

std::string wearer_csv(const std::vector<WearerRow>& rows, double clear_D) {
  CsvWriter csv;
  for (const char* heading : {"wearer", "sphere_D", "cylinder_D", "axis_deg", "age_years", "amplitude_D", "lens",
                              "addition_D", "distance_m", "gazes", "lost"})
    csv.text(heading);
  csv.text("share_above_" + plain_number(clear_D) + "_D");
  for (const char* heading : {"median_D", "largest_D", "largest_azimuth_deg", "largest_elevation_deg", "status"})
    csv.text(heading);
  csv.end_row();
  for (const WearerRow& row : rows) {
    csv.text(row.wearer);
    csv.number(row.prescription.sphere_D);
    csv.number(row.prescription.cylinder_D);
    csv.number(row.prescription.axis_deg);
    csv.number(row.age_years);
    csv.number(row.amplitude_D);
    csv.text(row.lens);
    csv.number(row.addition_D);
    if (std::isinf(row.distance_m))
      csv.text("inf");
    else
      csv.number(row.distance_m);
    csv.number(row.gazes);
    csv.number(row.lost);
    if (row.lost == row.gazes) {
      csv.empty(5);
    } else {
      csv.number(row.share_blurred, 6);
      csv.number(row.median_D, 6);
      csv.number(row.largest_D, 6);
      csv.number(row.largest_azimuth_deg);
      csv.number(row.largest_elevation_deg);
    }
    csv.text(row.not_made.empty() ? "ok" : row.not_made);
    csv.end_row();
  }
  return csv.table();
}

}  // namespace sturm
