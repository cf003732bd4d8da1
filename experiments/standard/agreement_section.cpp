#include "experiments/standard/agreement_section.h"

#include <nlohmann/json.hpp>

#include "experiments/run/scene_fingerprint.h"
#include "experiments/run/sections.h"
#include "io/files/sha256.h"
#include "pathtrace/scene/scene_import.h"

namespace sturm {

namespace {

class AgreementRun : public SectionRun {
 public:
  explicit AgreementRun(const ExperimentSpec& spec) : spec_(spec) {
    for (const AgreementCase& c : spec.agreement) scenes_.push_back(build_scene(c.scene));
  }

  std::string depends_on() const override {
    std::string facts;
    for (const SceneDescription& scene : scenes_) facts += scene_fingerprint(scene);
    for (const AgreementCase& c : spec_.agreement)
      for (const std::string& file : c.input_files) facts += sha256_of_file(file);
    return facts;
  }

  std::vector<std::string> folders() const override { return {"images"}; }

  void run(const SectionPlace& place, Json& report) override {
    for (std::size_t i = 0; i < spec_.agreement.size(); ++i) {
      const AgreementCase& c = spec_.agreement[i];
      report["agreement"].push_back(
          place.steps("agreement_" + c.id, "agreement " + c.id, [&](const ProgressFunction& progress) {
            return agreement_entry(c, scenes_[i], spec_.seed, place.folder.path(), progress);
          }));
    }
  }

 private:
  const ExperimentSpec& spec_;
  std::vector<SceneDescription> scenes_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_agreement(const ExperimentSpec& spec, const RunOptions&) {
  return spec.agreement.empty() ? nullptr : std::make_unique<AgreementRun>(spec);
}

}  // namespace sturm
