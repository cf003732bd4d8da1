#pragma once
#include <map>
#include <optional>
#include <string>

#include "io/json.h"

namespace sturm {

/// A number of a report that another run of the same experiment has, too.
struct Quantity {
  enum class Better { Unknown, Less, More, Nearer };

  std::optional<double> value{};           ///< none: the report has no number there
  std::optional<double> standard_error{};  ///< none: the report states none
  std::optional<double> degrees{};         ///< of freedom of the standard error; none: as good as known
  Better better = Better::Unknown;
  std::optional<double> target{};  ///< of Better::Nearer: what the number should be
};

/// The numbers of a report that sums up a run ("sturm.report/1"), by name, e.g. "ellipse P172-OS|1 m|6 mm, power_matrix: covariance xx
/// [rad²]": ellipses of rays, PSFs, images, the conoid's own semi-axes, agreement with the reference and orders of the lens study. Times
/// and the values of gates, which are made of these numbers, are left out.
std::map<std::string, Quantity> quantities_of(const Json& report);

/// Degrees of freedom of the standard errors of image `id`: its replicates, as the report's experiment states them, less one. None where
/// the report does not say.
std::optional<double> degrees_of_image(const Json& report, const std::string& id);

}  // namespace sturm
