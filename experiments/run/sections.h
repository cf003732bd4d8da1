#pragma once
#include <filesystem>
#include <functional>

#include "experiments/run/mutations.h"
#include "experiments/run/shared_views.h"
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

/// Image number `index` of an experiment: one scene path traced with each ray model and predicted once: a list of
/// "images" entries.
Json image_entries(const ExperimentSpec& experiment, std::size_t index, const SceneDescription& description,
                   SharedViews& views, const std::filesystem::path& folder, const ProgressFunction& progress);

/// One view path traced and predicted in several ways, with times and errors by region: one entry of "agreement".
Json agreement_entry(const AgreementCase& spec, const SceneDescription& description, std::uint64_t seed,
                     const std::filesystem::path& folder, const ProgressFunction& progress);

/// The comparison of rays with the conoid again, with a conoid that is wrong on purpose: mirrored axis, vertex distance
/// dropped, and sin² rays passed off as matrix rays. Each must be noticed.
Json must_fail_checks(const EllipseExperiment& spec, const Json& ellipses);

/// The measured facts about sin² in one sentence; null without the section.
Json sin2_sentence(const Json& sin2);

}  // namespace sturm
