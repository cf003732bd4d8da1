#include "experiments/standard/reference_section.h"

#include <nlohmann/json.hpp>

#include "experiments/standard/reference_agreement.h"

namespace sturm {

namespace {

class ReferenceRun : public SectionRun {
 public:
  explicit ReferenceRun(const std::filesystem::path& file) : agreement_(reference_agreement(file)) {}

  void run(const SectionPlace&, Json& report) override { report["reference"] = to_json(agreement_); }

 private:
  ReferenceFinding agreement_;
};

}  // namespace

std::unique_ptr<SectionRun> prepared_reference(const ExperimentSpec& spec, const RunOptions&) {
  return spec.reference ? std::make_unique<ReferenceRun>(*spec.reference) : nullptr;
}

}  // namespace sturm
