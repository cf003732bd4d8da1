#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "compare/studies/bench/bench_findings.h"
#include "compare/studies/lens/lens_findings.h"
#include "compare/studies/samplings/sampling_findings.h"
#include "compare/studies/sin2/sin2_findings.h"
#include "support/source_folder.h"

/// Reports that the program has written (tests/reference/reports/): read and written again they are the same text.
namespace sturm {
namespace {

Json stored(const std::string& name) {
  return load_json(std::string(STURM_SOURCE_DIR) + "/tests/reference/reports/" + name + ".json");
}

TEST(StoredFindings, SamplingStudy) {
  const Json report = stored("sampling_study");
  const SamplingFindings found = sampling_findings(report).value();
  EXPECT_EQ(to_json(found).dump(1), report["sampling_study"].dump(1));
  EXPECT_EQ(found.entries.size(), 8u);
  EXPECT_EQ(found.entries[0].ray_model, RayModel::pinhole);
  EXPECT_EQ(found.entries[1].sampling, PupilSampling::UniformPolar);
  EXPECT_EQ(sampling_entries_from(to_json(found.entries)), found.entries);
}

TEST(StoredFindings, LensStudy) {
  const Json report = stored("lens_study");
  const LensFindings found = lens_findings(report).value();
  EXPECT_EQ(to_json(found).dump(1), report["lens_study"].dump(1));
  EXPECT_EQ(found.lenses.size(), 3u);
  EXPECT_FALSE(found.views[0].direction_deg);  // straight ahead
  EXPECT_TRUE(found.views[1].distance_m->is_infinite());
  EXPECT_EQ(found.gazes.back().status, "missed_lens");
  EXPECT_FALSE(found.gazes.back().eq11);
  EXPECT_EQ(lens_field_from(to_json(*found.field)), *found.field);
}

TEST(StoredFindings, Sin2Study) {
  const Json report = stored("sin2_study");
  const Sin2StudyFindings found = sin2_study_findings(report).value();
  EXPECT_EQ(to_json(found).dump(1), report["sin2_study"].dump(1));
  EXPECT_EQ(found.check("cases")->value, 336.0);
  EXPECT_EQ(found.worst_views(RayModel::sin2_radial)->eyes, 2);
  EXPECT_EQ(sin2_gallery_entry_from(to_json(found.gallery[0])), found.gallery[0]);
}

TEST(StoredFindings, BenchSection) {
  const Json report = stored("bench_section");
  const BenchFindings found = bench_findings(report).value();
  EXPECT_EQ(to_json(found).dump(1), report["bench"].dump(1));
  EXPECT_TRUE(found.views[0].methods[0].biased);
  EXPECT_EQ(found.views[0].methods[0].times[1].status, Reach::Never);
  EXPECT_FALSE(found.views[0].methods[0].slope("rmse").slope);
}

TEST(StoredFindings, BenchReport) {
  const Json report = stored("bench");
  const Json again = to_json(bench_report_findings(report));
  for (const auto& [key, value] : again.items()) EXPECT_EQ(value.dump(1), report[key].dump(1)) << key;
}

TEST(StoredFindings, AReportWithoutASectionHasNoFindings) {
  for (const Json& report : {Json::object(), Json(nullptr), Json{{"lens_study", nullptr}, {"sin2_study", 3}}}) {
    EXPECT_FALSE(sampling_findings(report));
    EXPECT_FALSE(lens_findings(report));
    EXPECT_FALSE(sin2_study_findings(report));
    EXPECT_FALSE(bench_findings(report));
  }
}

}  // namespace
}  // namespace sturm
