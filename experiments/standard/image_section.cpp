#include "experiments/standard/image_section.h"

#include <nlohmann/json.hpp>

#include "experiments/run/scene_fingerprint.h"
#include "experiments/run/sections.h"
#include "pathtrace/scene/scene_import.h"

namespace sturm {

namespace {

class ImageRun : public SectionRun {
 public:
  explicit ImageRun(const ExperimentSpec& spec) : spec_(spec) {
    for (const ImageExperiment& image : spec.images) scenes_.push_back(build_scene(image.scene));
  }

  std::string depends_on() const override {
    std::string facts;
    for (const SceneDescription& scene : scenes_) facts += scene_fingerprint(scene);
    return facts;
  }

  std::vector<std::string> folders() const override { return {"images"}; }

  void run(const SectionPlace& place, Json& report) override {
    SharedViews views(spec_, scenes_);
    for (std::size_t i = 0; i < spec_.images.size(); ++i) {
      const std::string& id = spec_.images[i].id;
      append(report["images"], place.steps("image_" + id, "image " + id, [&](const ProgressFunction& progress) {
        return image_entries(spec_, i, scenes_[i], views, place.folder.path(), progress);
      }));
    }
  }

 private:
  const ExperimentSpec& spec_;
  std::vector<SceneDescription> scenes_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_images(const ExperimentSpec& spec, const RunOptions&) {
  return spec.images.empty() ? nullptr : std::make_unique<ImageRun>(spec);
}

}  // namespace sturm
