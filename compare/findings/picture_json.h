#pragma once
#include <vector>

#include "compare/findings/pictures.h"
#include "io/json/json.h"

namespace sturm {

/// An entry of the list of the report that belongs to its measures ("images", "agreement"), with "mutated" if there is
/// any.
Json to_json(const PictureFinding& finding);

/// Whatever is missing, null or of another type is none. `replicates`: of an entry of "images", which does not state
/// them.
PictureFinding picture_finding(const Json& entry, PictureMeasures measures,
                               std::optional<std::uint64_t> replicates = std::nullopt);

/// All pictures of a report ("sturm.report/1"): those with metrics, then those by region.
std::vector<PictureFinding> picture_findings(const Json& report);

}  // namespace sturm
