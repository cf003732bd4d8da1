#include "experiments/sin2_study/section.h"

#include <nlohmann/json.hpp>

#include "compare/studies/sin2/summary.h"
#include "experiments/sin2_study/sin2_study.h"
#include "io/files/atomic_file.h"
#include "io/files/sha256.h"
#include "reports/sections/sin2_study/figures.h"

namespace sturm {

namespace {

class Sin2Run : public SectionRun {
 public:
  Sin2Run(const Sin2StudySpec& spec, std::uint64_t seed) : spec_(spec), seed_(seed) {}

  std::string depends_on() const override {
    std::string facts;
    for (const std::string& table : spec_.input_files) facts += sha256_of_file(table);
    return facts;
  }

  std::vector<std::string> folders() const override { return {"psf"}; }

  void run(const SectionPlace& place, Json& report) override {
    std::vector<StudyCase> cases;
    for (const StudyEyeGroup& group : spec_.groups)
      for (const Json& row :
           place.steps("sin2_" + group.name, "sin² " + group.name,
                       [&](const ProgressFunction& progress) { return sin2_study_rows(spec_, group, progress); }))
        cases.push_back(case_of(row));
    std::vector<Sin2GalleryEntry> gallery;
    for (const Sin2GalleryView& view : spec_.gallery)
      gallery.push_back(
          sin2_gallery_entry_from(place.steps("sin2_psf_" + view.id, "PSFs " + view.id, [&](const ProgressFunction&) {
            return to_json(sin2_gallery_entry(spec_, view, seed_, place.folder.path()));
          })));
    write_file_atomically(place.folder.path() / "sin2_study.csv", sin2_study_csv(cases, spec_));
    const Sin2StudyFindings found = summarised_sin2_study(spec_, cases, std::move(gallery));
    report["sin2_study"] = to_json(found);
  }

  std::span<const OwnMutation> own_mutations() const override { return sin2_study_mutations(); }

  void mutate(const std::string& mutation, Json& report) const override {
    report["sin2_study"] = to_json(mutated_sin2_study(*sin2_study_findings(report), mutation));
  }

  std::vector<Figure> figures(const Json& report, const RunFolder& folder, const std::string& command) const override {
    std::vector<Figure> drawn = sin2_study_figures(*sin2_study_findings(report), folder.path());
    for (Figure& figure : drawn) figure.command = command;
    return drawn;
  }

  Json sentence(const Json& report) const override { return sin2_study_sentence(*sin2_study_findings(report)); }

 private:
  const Sin2StudySpec& spec_;
  std::uint64_t seed_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_sin2_study(const ExperimentSpec& spec, const RunOptions&) {
  return spec.sin2_study ? std::make_unique<Sin2Run>(*spec.sin2_study, spec.seed) : nullptr;
}

}  // namespace sturm
