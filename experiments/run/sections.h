#pragma once
#include <filesystem>
#include <functional>

#include "experiments/run/mutations.h"
#include "io/json/json.h"
#include "io/specs/experiment/experiment_spec.h"
#include "stages/render_stage.h"

namespace sturm {

/// Each section of a report is a function from the experiment to JSON (configs/schemas/report.schema.json); pictures go
/// into `folder`. What mutations make of an entry stands in it under "mutated", by the mutation's id
/// (compare/findings/gate_power.h).

/// The conoid and the closed form of sin² against independent numbers in the experiment's reference file.
Json reference_agreement(const std::filesystem::path& reference_file);

/// Blur ellipses: every prescription × distance × pupil by the conoid and by every ray model.
Json ellipse_results(const EllipseExperiment& spec, std::uint64_t seed, std::span<const Mutation> mutations,
                     const ProgressFunction& progress);

/// What sin² interpolation does, from the finished ellipse section.
Json sin2_findings(const Json& ellipses);

/// Image of a point-like emitter for each ray model of one PSF experiment: a list of "psfs" entries.
Json psf_entries(const PsfExperiment& spec, std::uint64_t seed, std::span<const Mutation> mutations,
                 const std::filesystem::path& folder, const ProgressFunction& progress);

/// The comparison of rays with the conoid again, with a conoid that is wrong on purpose: mirrored axis, vertex distance
/// dropped, and sin² rays passed off as matrix rays. Each must be noticed.
Json must_fail_checks(const EllipseExperiment& spec, const Json& ellipses);

/// One lens of the accuracy study: {"lens", "gazes", "views"}, its share of the section "lens_study" of the report.
/// Gazes are traced in parallel; the result does not depend on the number of threads.
Json lens_study_of(const LensStudySpec& spec, const StudyLens& lens, const ProgressFunction& progress);

/// The ellipses of all methods over the wide field.
Json wide_gaze_study(const LensStudySpec& spec, const WideGaze& gaze);

/// The section, put together from what the lenses gave; `field` may be null.
Json assembled_lens_study(const LensStudySpec& spec, const Json& lenses, const Json& field);

/// The order of convergence again with footprints that are wrong on purpose; each must be noticed. From the finished
/// section.
Json lens_study_mutants(const Json& section);

/// The measured facts about conoid tracing in one sentence.
Json lens_study_sentence(const Json& section);

/// The measured facts about sin² in one sentence; null without the section.
Json sin2_sentence(const Json& sin2);

}  // namespace sturm
