#pragma once
#include <filesystem>

#include "compare/studies/bench/bench_findings.h"
#include "compare/studies/bench/reference_image.h"
#include "io/specs/experiment/bench_spec.h"

namespace sturm {

/// What a benchmark's pictures of one view are measured against, and how it came about.
struct BenchReference {
  ReferenceImage image;
  BenchReferenceFacts facts;
};

/// What the reference's pixels depend on, the program aside: resolved view, seed, the scene as loaded, and all files
/// that are named. Hex digits.
std::string reference_key(const BenchView& view, std::uint64_t seed);

/// Renders the two halves of a view's reference, or takes them from folder/references, where they lie under the name of
/// their key: a reference outlives the program that made it, so that an error of a later one shows; the facts say which
/// one that was. `key`: the view's `reference_key`.
BenchReference bench_reference(const BenchView& view, const std::string& key, std::uint64_t seed,
                               const std::filesystem::path& folder, bool quiet);

}  // namespace sturm
