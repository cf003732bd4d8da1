#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/studies/lens/lens_findings.h"

namespace sturm {

/// A method of the accuracy study.
struct StudyMethod {
  const char *key, *name;  ///< its word in tables for programs, and what readers see
  std::optional<MethodError> LensPupil::*error;
  std::optional<FirstOrderError> FirstOrderErrors::*first_order;  ///< null for the one that is the exact first order
};

/// In reading order.
inline constexpr StudyMethod study_methods[] = {
    {"ray_transfer", "ray transfer", &LensPupil::ray_transfer, nullptr},
    {"published", "as published (eq. 11)", &LensPupil::published, &FirstOrderErrors::published},
    {"previous", "previous (Table 1)", &LensPupil::previous, &FirstOrderErrors::previous}};

/// The defocus [D] of an error that may be missing.
template <class Error>
Number defocus_of(const std::optional<Error>& error) {
  return error ? error->defocus_D : std::nullopt;
}

/// Above these an error of a blur ellipse matters to somebody who looks through the lens: a fifth of the smallest step
/// that lenses are ordered in, and the resolution of a healthy eye.
inline constexpr double defocus_that_matters_D = 0.05;
inline constexpr double blur_that_matters_arcmin = 1.0;

/// The worst error of a method over the directions and distances of one eccentricity.
struct WorstError {
  std::optional<double> defocus_D, half_width_arcmin;
  std::string defocus_view;  ///< where the larger defocus stands
  int without = 0;           ///< views in which the method has no ellipse, or real rays were lost
};

/// The errors against real rays of the accuracy study.
class LensStudyErrors {
 public:
  explicit LensStudyErrors(const LensFindings& found);

  const std::vector<std::string>& lenses() const { return lenses_; }
  const std::vector<double>& eccentricities_deg() const { return eccentricities_; }
  const std::vector<double>& pupils_mm() const { return pupils_; }

  /// Of one cell; without any view there is nothing in it.
  WorstError at(const std::string& lens, const std::string& method, double eccentricity_deg, double pupil_mm) const;

  /// Over all eccentricities.
  WorstError over_gazes(const std::string& lens, const std::string& method, double pupil_mm) const;

 private:
  struct Cell {
    std::string lens, method;
    double eccentricity, pupil;
    auto operator<=>(const Cell&) const = default;
  };
  std::vector<std::string> lenses_;
  std::vector<double> eccentricities_, pupils_;
  std::map<Cell, WorstError> cells_;
};

}  // namespace sturm
