#include "experiments/depth_psf/section.h"

#include <nlohmann/json.hpp>

#include "experiments/depth_psf/depth_psf_study.h"
#include "io/files/formatted_text.h"
#include "io/files/sha256.h"

namespace sturm {

namespace {

class DepthPsfRun : public SectionRun {
 public:
  explicit DepthPsfRun(const DepthPsfStudySpec& spec) : spec_(spec) {}

  std::string depends_on() const override {
    std::string facts;
    for (const std::string& table : spec_.input_files) facts += sha256_of_file(table);
    return facts;
  }

  void run(const SectionPlace& place, Json& report) override {
    DepthPsfFindings found;
    if (spec_.map)
      for (const double pupil_m : spec_.map->pupil_diameters_m) {
        const std::string pupil = plain_number(1e3 * pupil_m);
        const Json cells =
            place.steps("depth_psf_map_" + pupil, "rays and waves, pupil " + pupil + " mm",
                        [&](const ProgressFunction&) { return to_json(spread_cells(*spec_.map, pupil_m)); });
        for (SpreadCell& cell : spread_cells_from(cells)) found.map.push_back(std::move(cell));
      }
    for (const MeasuredEyes& eyes : spec_.eyes)
      found.eyes.push_back(
          eyes_beyond_from(place.steps("depth_psf_eyes_" + eyes.id, "eyes " + eyes.id,
                                       [&](const ProgressFunction& p) { return to_json(eyes_beyond(eyes, p)); })));
    if (spec_.banding)
      found.banding = banding_rows_from(place.steps(
          "depth_psf_banding", "a slanted surface",
          [&](const ProgressFunction& progress) { return to_json(banding_rows(*spec_.banding, progress)); }));
    report["depth_psf_study"] = to_json(found);
  }

 private:
  const DepthPsfStudySpec& spec_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_depth_psf_study(const ExperimentSpec& spec, const RunOptions&) {
  return spec.depth_psf_study ? std::make_unique<DepthPsfRun>(*spec.depth_psf_study) : nullptr;
}

}  // namespace sturm
