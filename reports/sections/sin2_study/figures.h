#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "compare/studies/sin2/sin2_findings.h"
#include "reports/plots/figure.h"

namespace sturm {

/// Error over sphere and cylinder of the grid, a panel per model.
std::optional<Figure> sin2_error_map(const Sin2StudyFindings& found);

/// Blur against the sphere without a cylinder: wavefront theory, sin², focal distances added.
std::optional<Figure> sin2_sphere_curves(const Sin2StudyFindings& found);

/// Share of the real eyes whose error is above a value.
std::optional<Figure> sin2_population_curves(const Sin2StudyFindings& found);

/// Point-spread functions side by side, log scale; densities are read from `run_folder`.
std::optional<Figure> sin2_gallery(const Sin2StudyFindings& found, const std::filesystem::path& run_folder);

/// All pictures of the section "sin2_study" that it has numbers for.
std::vector<Figure> sin2_study_figures(const Sin2StudyFindings& found, const std::filesystem::path& run_folder);

}  // namespace sturm
