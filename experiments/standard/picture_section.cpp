#include "experiments/standard/picture_section.h"

#include <map>
#include <nlohmann/json.hpp>

#include "compare/findings/picture_json.h"
#include "experiments/run/mutated_entries.h"
#include "experiments/run/scene_fingerprint.h"
#include "experiments/standard/metric_findings.h"
#include "experiments/standard/region_findings.h"
#include "io/files/sha256.h"
#include "pathtrace/scene/scene_import.h"

namespace sturm {

namespace {

class PictureRun : public SectionRun {
 public:
  explicit PictureRun(const ExperimentSpec& spec) : spec_(spec) {
    for (const PictureExperiment& picture : spec.pictures) scenes_.push_back(build_scene(picture.scene));
  }

  std::string depends_on() const override {
    std::string facts;
    for (const SceneDescription& scene : scenes_) facts += scene_fingerprint(scene);
    for (const PictureExperiment& picture : spec_.pictures)
      for (const std::string& file : picture.input_files) facts += sha256_of_file(file);
    return facts;
  }

  std::vector<std::string> folders() const override { return {"images"}; }

  void run(const SectionPlace& place, Json& report) override {
    SharedViews views(spec_, scenes_);
    for (std::size_t i = 0; i < spec_.pictures.size(); ++i) {
      const PictureExperiment& picture = spec_.pictures[i];
      const std::string word = picture.measures == PictureMeasures::Metrics ? "image" : "agreement";
      Json& list = entries_[list_name(picture.measures)];
      if (list.is_null()) list = Json::array();
      append(list, place.steps(word + "_" + picture.id, word + " " + picture.id, [&](const ProgressFunction& progress) {
        Json entries = Json::array();
        for (const PictureFinding& finding : findings_of(i, views, place, progress))
          entries.push_back(to_json(finding));
        return entries;
      }));
    }
    for (const auto& [list, entries] : entries_) report[list] = honest_entries(entries);
  }

  void mutate(const std::string& mutation, Json& report) const override {
    for (const auto& [list, entries] : entries_) report[list] = mutated_entries(entries, mutation);
  }

 private:
  std::vector<PictureFinding> findings_of(std::size_t index, SharedViews& views, const SectionPlace& place,
                                          const ProgressFunction& progress) const {
    const PictureExperiment& picture = spec_.pictures[index];
    const std::filesystem::path folder = place.folder.path();
    if (picture.measures == PictureMeasures::Metrics)
      return metric_findings(spec_, index, scenes_[index], views, place.mutations, folder, progress);
    return {region_finding(picture, scenes_[index], spec_.seed, place.mutations, folder, progress)};
  }

  const ExperimentSpec& spec_;
  std::vector<SceneDescription> scenes_;
  std::map<std::string, Json> entries_;  ///< of each list of the report, with what mutations make of them
};

}  // namespace

std::unique_ptr<SectionRun> prepared_pictures(const ExperimentSpec& spec, const RunOptions&) {
  return spec.pictures.empty() ? nullptr : std::make_unique<PictureRun>(spec);
}

}  // namespace sturm
