#include <cmath>
#include <nlohmann/json.hpp>

#include "io/json/values.h"
#include "lensmodel/units.h"
#include "lensmodel/zernike_order.h"
#include "stages/wavefront_stage.h"

namespace sturm {

namespace {

double millimetres(double metres) {
  return metres / metres_per_millimetre;
}

Json place_json(const SensorPoint& point) {
  return {{"line", point.line}, {"x_mm", millimetres(point.point.x())}, {"y_mm", millimetres(point.point.y())}};
}

Json places_json(const std::vector<SensorPoint>& points) {
  Json list = Json::array();
  for (const SensorPoint& point : points) list.push_back(place_json(point));
  return list;
}

/// Residuals in the unit of the report: slopes in rad, heights in µm.
double residual_unit(bool heights) {
  return heights ? metres_per_micrometre : 1.0;
}

Json scaled(const std::optional<double>& value, double unit) {
  return value ? number_or_null(*value / unit) : Json(nullptr);
}

Json residuals_json(const FittedWavefront& fitted, double unit, bool spurious_only) {
  const auto rows = static_cast<std::size_t>(fitted.fit.residuals.size()) / fitted.points.size();
  Json list = Json::array();
  for (std::size_t i = 0; i < fitted.points.size(); ++i) {
    if (spurious_only && fitted.fit.used[i]) continue;
    Json entry = place_json(fitted.points[i]);
    Json& residual = entry["residual"] = Json::array();
    for (std::size_t k = 0; k < rows; ++k)
      residual.push_back(number_or_null(fitted.fit.residuals[static_cast<Eigen::Index>(i * rows + k)] / unit));
    entry["used"] = static_cast<bool>(fitted.fit.used[i]);
    list.push_back(std::move(entry));
  }
  return list;
}

/// +1 or −1 for each mode of a fit: what a mirror makes of its coefficient.
Eigen::VectorXd signs_of(const ModalFit& fit, bool mirror) {
  Eigen::VectorXd signs = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(fit.modes.size()));
  if (!mirror || fit.modes.empty()) return signs;
  const std::vector<double> of_all = mirrored(std::vector<double>(static_cast<std::size_t>(fit.modes.back()) + 1, 1.0));
  for (Eigen::Index i = 0; i < signs.size(); ++i)
    signs[i] = of_all[static_cast<std::size_t>(fit.modes[static_cast<std::size_t>(i)])];
  return signs;
}

Json coefficients_json(const ModalFit& fit, const Eigen::VectorXd& signs, const std::optional<double>& noise) {
  Json list = Json::array();
  for (std::size_t i = 0; i < fit.modes.size(); ++i) {
    const ZernikeIndex index = ZernikeIndex::of(fit.modes[i]);
    const auto k = static_cast<int>(i);
    list.push_back({{"j", fit.modes[i]},
                    {"n", index.n},
                    {"m", index.m},
                    {"value_um", signs[k] * fit.coefficients[k] / metres_per_micrometre},
                    {"standard_error_um",
                     noise ? number_or_null(fit.standard_error(k, *noise) / metres_per_micrometre) : Json(nullptr)}});
  }
  return list;
}

Json covariance_json(const ModalFit& fit, const Eigen::VectorXd& signs, const std::optional<double>& noise) {
  if (!noise) return nullptr;
  const double scale = *noise * *noise / (metres_per_micrometre * metres_per_micrometre);
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < fit.unit_covariance.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index k = 0; k <= i; ++k) row.push_back(scale * signs[i] * signs[k] * fit.unit_covariance(i, k));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json trials_json(const std::optional<OrderChoice>& choice, double unit) {
  if (!choice) return nullptr;
  Json list = Json::array();
  for (const OrderTrial& trial : choice->trials)
    list.push_back({{"radial_order", trial.radial_order},
                    {"modes", trial.modes},
                    {"residual_rms", trial.residual_rms / unit},
                    {"left_out_rms", scaled(trial.left_out_rms, unit)}});
  return list;
}

}  // namespace

Json refraction_json(const std::vector<double>& coefficients_um, double pupil_mm) {
  std::vector<double> metres;
  double higher = 0.0;
  for (std::size_t j = 0; j < coefficients_um.size(); ++j) {
    metres.push_back(metres_per_micrometre * coefficients_um[j]);
    if (j > 5) higher += coefficients_um[j] * coefficients_um[j];
  }
  const PowerMatrix power =
      ZernikeWave::from_examiner(metres, 0.5 * metres_per_millimetre * pupil_mm).power(SecondOrder::LeastSquares);
  const Prescription rx = power.as_prescription();
  return {{"M_D", power.spherical_equivalent()},
          {"J0_D", 0.5 * (power.xx() - power.yy())},
          {"J45_D", -power.xy()},  // the examiner's sign
          {"sphere_D", rx.sphere_D},
          {"cylinder_D", rx.cylinder_D},
          {"axis_deg", rx.cylinder_D == 0.0 ? Json(nullptr) : Json(rx.axis_deg)},
          {"higher_order_rms_um", std::sqrt(higher)}};
}

Json wavefront_report(const WavefrontQuery& query, const FittedWavefront& fitted, bool mirror) {
  const ModalFit& fit = fitted.fit;
  const Eigen::VectorXd signs = signs_of(fit, mirror);
  const std::vector<double> coefficients_um = mirror ? mirrored(fitted.coefficients_um()) : fitted.coefficients_um();
  const double unit = residual_unit(query.table.heights);
  const std::optional<double> noise = query.noise ? query.noise : fit.noise;
  const Json spurious = residuals_json(fitted, unit, true);
  return {{"format", "sturm.wavefront_report/1"},
          {"measured", query.table.heights ? "heights" : "slopes"},
          {"pupil_diameter_mm", millimetres(2.0 * query.pupil_radius_m)},
          {"center", json_of(query.table.centre)},
          {"gradient", query.table.heights ? Json(nullptr) : Json(query.lenslet_m > 0.0 ? "mean" : "center")},
          {"lenslet_mm", query.lenslet_m > 0.0 ? Json(millimetres(query.lenslet_m)) : Json(nullptr)},
          {"samples",
           {{"rows", query.table.points.size() + query.table.missing.size()},
            {"used", fitted.points.size() - spurious.size()},
            {"missing", query.table.missing.size()},
            {"outside", fitted.outside.size()},
            {"spurious", spurious.size()}}},
          {"missing", places_json(query.table.heights ? std::vector<SensorPoint>{} : query.table.missing)},
          {"outside", places_json(query.table.heights ? std::vector<SensorPoint>{} : fitted.outside)},
          {"spurious", spurious},
          {"radial_order", fitted.radial_order},
          {"modes", fit.modes.size()},
          {"order_trials", trials_json(fitted.choice, unit)},
          {"condition_number", fit.condition_number},
          {"residual_unit", query.table.heights ? "um" : "rad"},
          {"residual_rms", fit.residual_rms / unit},
          {"left_out_rms", scaled(fit.left_out_rms, unit)},
          {"noise", scaled(noise, unit)},
          {"noise_is", query.noise ? "given" : "estimated"},
          {"coefficients", coefficients_json(fit, signs, noise)},
          {"covariance_um2", covariance_json(fit, signs, noise)},
          {"refraction", refraction_json(coefficients_um, millimetres(2.0 * query.pupil_radius_m))},
          {"residuals", residuals_json(fitted, unit, false)}};
}

Json eye_document(const WavefrontEye& eye) {
  Json coefficients = Json::object();
  for (std::size_t j = 0; j < eye.coefficients_um.size(); ++j)
    if (eye.coefficients_um[j] != 0.0) coefficients[std::to_string(j)] = eye.coefficients_um[j];
  if (coefficients.empty()) coefficients["0"] = 0.0;
  Json wavefront = {{"coefficients_um", std::move(coefficients)}, {"pupil_diameter_mm", eye.measured_pupil_mm}};
  if (eye.side) wavefront["eye"] = *eye.side;
  if (eye.wavelength_nm) wavefront["wavelength_nm"] = *eye.wavelength_nm;
  if (eye.second_order) wavefront["second_order"] = *eye.second_order;
  Json document = {{"format", "sturm.eye/1"},
                   {"source", eye.source},
                   {"wavefront", std::move(wavefront)},
                   {"pupil_diameter_mm", eye.pupil_mm}};
  document.update(eye.others);
  return document;
}

}  // namespace sturm
