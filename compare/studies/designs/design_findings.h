#pragma once
#include <optional>
#include <string>
#include <vector>

#include "compare/gates/extreme_statistic.h"
#include "io/json/record.h"

namespace sturm {

/// A lens design, made for its own prescription, as worn over its whole surface.
struct DesignFacts {
  std::string id{}, note{};
  Number sphere_D{}, cylinder_D{}, axis_deg{};    ///< that it was made for, or its power on its axis
  Number largest_mean_D{}, largest_cylinder_D{};  ///< of the error within the rim; the mean with its sign
  Number clear_area_percent{};  ///< of the lens: mean error and half of its cylinder together at most clear_D
  Number narrowest_deg{}, narrowest_elevation_deg{};  ///< of a progressive lens: its corridor, and where

  bool operator==(const DesignFacts&) const = default;
};

/// What one wearer sees of targets at one distance through one design, over all gazes that reach the lens.
struct DesignWearer {
  std::string wearer{}, design{};
  std::optional<StoredDistance> distance_m{};
  Number sphere_D{}, cylinder_D{}, axis_deg{}, age_years{}, amplitude_D{}, addition_D{};
  Count gazes{}, lost{};
  Number share_blurred{}, median_D{}, largest_D{};  ///< none where no gaze comes through
  std::string status{};                             ///< "ok", or why the design cannot be made for this wearer

  bool operator==(const DesignWearer&) const = default;
};

struct DesignConditions {
  Number clear_D{}, reach_deg{}, step_deg{}, rotation_center_mm{}, pupil_mm{}, amplitude_D{};

  bool operator==(const DesignConditions&) const = default;
};

/// Section "design_study" of a report.
struct DesignFindings {
  DesignConditions conditions{};
  std::vector<DesignFacts> designs{};
  std::vector<DesignWearer> wearers{};

  bool operator==(const DesignFindings&) const = default;
};

/// What a design does for a population at one distance.
struct DesignSummary {
  std::string design;
  std::optional<StoredDistance> distance_m;
  std::size_t wearers = 0, not_made = 0;        ///< in all, and those whom the design cannot be made for
  Number median_share{}, ninth_decile_share{};  ///< of the gazes that are blurred, over the others
  Number median_D{};                            ///< of their medians of defocus
};

Json to_json(const DesignFindings& findings);

/// Of a report; none without the section.
std::optional<DesignFindings> design_findings(const Json& report);

/// Parts of a run, both ways.
Json to_json(const DesignFacts& facts);
DesignFacts design_facts_from(const Json& value);
Json to_json(const std::vector<DesignWearer>& wearers);
std::vector<DesignWearer> design_wearers_from(const Json& list);

/// A summary for each design and distance, in the order in which they are found.
std::vector<DesignSummary> design_summaries(const DesignFindings& findings);

}  // namespace sturm
