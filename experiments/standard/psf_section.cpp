#include "experiments/standard/psf_section.h"

#include <nlohmann/json.hpp>

#include "experiments/run/mutated_entries.h"
#include "experiments/standard/psf_findings.h"

namespace sturm {

namespace {

class PsfRun : public SectionRun {
 public:
  explicit PsfRun(const ExperimentSpec& spec) : spec_(spec) {}

  std::vector<std::string> folders() const override { return {"psf"}; }

  void run(const SectionPlace& place, Json& report) override {
    for (const PsfExperiment& psf : spec_.psfs)
      append(entries_, place.steps("psf_" + psf.id, "PSF " + psf.id, [&](const ProgressFunction& progress) {
        return to_json(psf_findings(psf, spec_.seed, place.mutations, place.folder.path(), progress));
      }));
    report["psfs"] = honest_entries(entries_);
  }

  void mutate(const std::string& mutation, Json& report) const override {
    report["psfs"] = mutated_entries(entries_, mutation);
  }

 private:
  const ExperimentSpec& spec_;
  Json entries_ = Json::array();  ///< with what mutations make of them
};

}  // namespace

std::unique_ptr<SectionRun> prepared_psfs(const ExperimentSpec& spec, const RunOptions&) {
  return spec.psfs.empty() ? nullptr : std::make_unique<PsfRun>(spec);
}

}  // namespace sturm
