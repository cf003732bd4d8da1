#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiments/run/mutations.h"
#include "experiments/run/run_options.h"
#include "experiments/run/steps.h"
#include "io/specs/experiment/experiment_spec.h"
#include "reports/plots/figure.h"

namespace sturm {

/// What a section is made with.
struct SectionPlace {
  const RunFolder& folder;
  Steps& steps;
  std::span<const Mutation> mutations;
  int threads;
  bool quiet;
};

/// One section of an experiment's report. It is prepared before the run folder is touched, so that everything that can
/// be wrong with the input shows first, then run, then it draws its figures.
class SectionRun {
 public:
  virtual ~SectionRun() = default;

  /// Whatever a finished step depends on besides the resolved spec and the program: hashes and fingerprints.
  virtual std::string depends_on() const { return ""; }

  /// Folders of the run folder that it writes pictures into.
  virtual std::vector<std::string> folders() const { return {}; }

  /// Enters the section into the report.
  virtual void run(const SectionPlace& place, Json& report) = 0;

  /// The errors that it tries on itself in every run: mutate() knows them.
  virtual std::span<const OwnMutation> own_mutations() const { return {}; }

  /// Puts what a mutated predictor would have found in the section's place in the report; nothing where the mutation is
  /// none of this section.
  virtual void mutate(const std::string& mutation, Json& report) const { (void)mutation, (void)report; }

  /// Pictures of the finished section; `command` is how a reader gets them again.
  virtual std::vector<Figure> figures(const Json& report, const RunFolder& folder, const std::string& command) const {
    (void)report, (void)folder, (void)command;
    return {};
  }

  /// The measured facts in one sentence; null where there are none.
  virtual Json sentence(const Json& report) const {
    (void)report;
    return nullptr;
  }
};

/// Adds the elements of one list to another.
void append(Json& list, const Json& entries);

/// A kind of section; see experiments/sections.cpp.
struct ExperimentSection {
  const char* name;          ///< of its time in the provenance
  const char* sentence_key;  ///< of its sentence in the verdict; null if it never has one
  const char* table;         ///< file that it writes into the run folder; null if none
  /// Null where the experiment does not ask for it. Throws InputError.
  std::unique_ptr<SectionRun> (*prepared)(const ExperimentSpec& spec, const RunOptions& options);
};

}  // namespace sturm
