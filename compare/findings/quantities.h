#pragma once
#include <map>
#include <optional>
#include <string>

#include "io/json/json.h"

namespace sturm {

/// A number of a report that another run of the same experiment has, too.
struct Quantity {
  enum class Better { Unknown, Less, More, Nearer };

  std::optional<double> value{};           ///< none: the report has no number there
  std::optional<double> standard_error{};  ///< none: the report states none
  std::optional<double> degrees{};         ///< of freedom of the standard error; none: as good as known
  /// How far noise or rounding alone may take the number from what it stands for; a bound where no standard error is
  /// known.
  std::optional<double> bound{};
  Better better = Better::Unknown;
  std::optional<double> target{};  ///< of Better::Nearer: what the number should be
  bool may_vanish = false;         ///< noise or a better result alone may leave a report without the number
};

/// The numbers of a report that sums up a run ("sturm.report/1"), by name, e.g. "ellipse P172-OS|1 m|6 mm,
/// power_matrix: covariance xx [rad²]": ellipses of rays, PSFs, images, the conoid's own semi-axes, agreement with the
/// reference and orders of the lens study; agreement of predictions and how much faster they are, noise floors, the
/// study of pupil samplings and that of sin². Times themselves and the values of gates, which are made of these
/// numbers, are left out.
std::map<std::string, Quantity> quantities_of(const Json& report);

/// Its parts in compare/findings/study_quantities.cpp: the sections "agreement", "sampling_study" and "sin2_study".
void add_study_quantities(const Json& report, std::map<std::string, Quantity>& out);

/// The noise floors of images and predictions under `name` (ends with ": "): of an entry of the report that has
/// `noise_floor`, with standard errors where it has `noise_floor_uncertainty`, whose two halves of `replicates`
/// pictures have one degree of freedom less each.
void add_noise_floor(const Json& entry, const std::string& name, std::optional<double> replicates,
                     std::map<std::string, Quantity>& out);

/// Degrees of freedom of the standard error of one metric of image `id`: those that it states, else the image's
/// replicates, as the report's experiment states them, less one. None where the report does not say.
std::optional<double> degrees_of_metric(const Json& report, const std::string& id, const Json& metric);

}  // namespace sturm
