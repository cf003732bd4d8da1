#include "experiments/standard/psf_section.h"

#include <nlohmann/json.hpp>

#include "experiments/run/sections.h"

namespace sturm {

namespace {

class PsfRun : public SectionRun {
 public:
  explicit PsfRun(const ExperimentSpec& spec) : spec_(spec) {}

  std::vector<std::string> folders() const override { return {"psf"}; }

  void run(const SectionPlace& place, Json& report) override {
    for (const PsfExperiment& psf : spec_.psfs)
      append(report["psfs"], place.steps("psf_" + psf.id, "PSF " + psf.id, [&](const ProgressFunction& progress) {
        return psf_entries(psf, spec_.seed, place.mutations, place.folder.path(), progress);
      }));
  }

 private:
  const ExperimentSpec& spec_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_psfs(const ExperimentSpec& spec, const RunOptions&) {
  return spec.psfs.empty() ? nullptr : std::make_unique<PsfRun>(spec);
}

}  // namespace sturm
