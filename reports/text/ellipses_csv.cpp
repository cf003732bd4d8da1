#include "reports/text/ellipses_csv.h"

#include <variant>

#include "io/files/csv.h"
#include "io/json/stored_values.h"

namespace sturm {

namespace {

using Field = std::variant<Number, std::string>;

template <class Finding>
struct CsvColumn {
  const char* heading;
  Field (*field)(const Finding& finding);
};

using Case = EllipseFinding;
using Rays = RayFinding;

Number semi_axis(const std::optional<Ellipse>& e, double Ellipse::*length) {
  return e ? Number((*e).*length) : std::nullopt;
}

Number orientation(const std::optional<Ellipse>& e) {
  return e ? e->orientation_deg : std::nullopt;
}

Number entry(const std::optional<Eigen::Matrix2d>& m, int i, int j) {
  return m ? Number((*m)(i, j)) : std::nullopt;
}

Number entry(const std::optional<Eigen::Vector3d>& v, int i) {
  return v ? Number((*v)(i)) : std::nullopt;
}

Number count(const Rays& r, std::uint64_t RayCounts::*of) {
  return r.counts ? Number(static_cast<double>((*r.counts).*of)) : std::nullopt;
}

ConoidComparison conoid(const Rays& r) {
  return r.against_conoid.value_or(ConoidComparison{});
}

EllipseAgreement closed_form(const Rays& r) {
  return r.against_closed_form.value_or(EllipseAgreement{});
}

std::string status(const Rays& r) {
  return r.status ? std::string(ray_status_words.word_of(*r.status)) : std::string();
}

constexpr CsvColumn<Case> case_columns[] = {
    {"case", [](const Case& c) -> Field { return c.id; }},
    {"prescription", [](const Case& c) -> Field { return c.prescription; }},
    {"sphere_D", [](const Case& c) -> Field { return c.sphere_D; }},
    {"cylinder_D", [](const Case& c) -> Field { return c.cylinder_D; }},
    {"axis_deg", [](const Case& c) -> Field { return c.axis_deg; }},
    {"vertex_distance_mm", [](const Case& c) -> Field { return c.vertex_distance_mm; }},
    {"distance_m", [](const Case& c) -> Field { return c.distance_m; }},
    {"pupil_mm", [](const Case& c) -> Field { return c.pupil_mm; }},
    {"accommodation_D", [](const Case& c) -> Field { return c.accommodation_D; }},
    {"conoid_semi_major_rad", [](const Case& c) -> Field { return semi_axis(c.conoid.ellipse, &Ellipse::semi_major); }},
    {"conoid_semi_minor_rad", [](const Case& c) -> Field { return semi_axis(c.conoid.ellipse, &Ellipse::semi_minor); }},
    {"conoid_orientation_deg", [](const Case& c) -> Field { return orientation(c.conoid.ellipse); }},
    {"conoid_covariance_xx_rad2", [](const Case& c) -> Field { return entry(c.conoid.covariance_rad2, 0, 0); }},
    {"conoid_covariance_xy_rad2", [](const Case& c) -> Field { return entry(c.conoid.covariance_rad2, 0, 1); }},
    {"conoid_covariance_yy_rad2", [](const Case& c) -> Field { return entry(c.conoid.covariance_rad2, 1, 1); }},
    {"sin2_closed_form_covariance_xx_rad2",
     [](const Case& c) -> Field { return entry(c.sin2_closed_form.covariance_rad2, 0, 0); }},
    {"sin2_closed_form_covariance_xy_rad2",
     [](const Case& c) -> Field { return entry(c.sin2_closed_form.covariance_rad2, 0, 1); }},
    {"sin2_closed_form_covariance_yy_rad2",
     [](const Case& c) -> Field { return entry(c.sin2_closed_form.covariance_rad2, 1, 1); }}};

constexpr CsvColumn<Rays> ray_columns[] = {
    {"ray_model", [](const Rays& r) -> Field { return name_of(r.model); }},
    {"status", [](const Rays& r) -> Field { return status(r); }},
    {"semi_major_rad", [](const Rays& r) -> Field { return semi_axis(r.ellipse, &Ellipse::semi_major); }},
    {"semi_minor_rad", [](const Rays& r) -> Field { return semi_axis(r.ellipse, &Ellipse::semi_minor); }},
    {"orientation_deg", [](const Rays& r) -> Field { return orientation(r.ellipse); }},
    {"covariance_xx_rad2", [](const Rays& r) -> Field { return entry(r.covariance_rad2, 0, 0); }},
    {"covariance_xy_rad2", [](const Rays& r) -> Field { return entry(r.covariance_rad2, 0, 1); }},
    {"covariance_yy_rad2", [](const Rays& r) -> Field { return entry(r.covariance_rad2, 1, 1); }},
    {"covariance_xx_standard_error_rad2",
     [](const Rays& r) -> Field { return entry(r.covariance_standard_error_rad2, 0); }},
    {"covariance_xy_standard_error_rad2",
     [](const Rays& r) -> Field { return entry(r.covariance_standard_error_rad2, 1); }},
    {"covariance_yy_standard_error_rad2",
     [](const Rays& r) -> Field { return entry(r.covariance_standard_error_rad2, 2); }},
    {"rays_launched", [](const Rays& r) -> Field { return count(r, &RayCounts::launched); }},
    {"rays_dropped", [](const Rays& r) -> Field { return count(r, &RayCounts::dropped); }},
    {"rays_negative_focus", [](const Rays& r) -> Field { return count(r, &RayCounts::negative_focus); }},
    {"conoid_z_max", [](const Rays& r) -> Field { return conoid(r).agreement.z_max; }},
    {"conoid_relative_frobenius", [](const Rays& r) -> Field { return conoid(r).agreement.relative_frobenius; }},
    {"conoid_semi_major_relative_error", [](const Rays& r) -> Field { return conoid(r).semi_axis_errors[0]; }},
    {"conoid_semi_minor_relative_error", [](const Rays& r) -> Field { return conoid(r).semi_axis_errors[1]; }},
    {"conoid_minor_axis_error_arcmin", [](const Rays& r) -> Field { return conoid(r).minor_axis_error_arcmin; }},
    {"conoid_orientation_error_deg", [](const Rays& r) -> Field { return conoid(r).orientation_error_deg; }},
    {"conoid_bures_wasserstein_arcmin", [](const Rays& r) -> Field { return conoid(r).bures_wasserstein_arcmin; }},
    {"closed_form_z_max", [](const Rays& r) -> Field { return closed_form(r).z_max; }},
    {"closed_form_relative_frobenius", [](const Rays& r) -> Field { return closed_form(r).relative_frobenius; }}};

template <class Finding, std::size_t N>
void add_fields(const Finding& finding, const CsvColumn<Finding> (&columns)[N], CsvWriter& csv) {
  for (const CsvColumn<Finding>& column : columns) {
    const Field field = column.field(finding);
    if (const Number* number = std::get_if<Number>(&field))
      csv.number(*number);
    else
      csv.text(std::get<std::string>(field));
  }
}

}  // namespace

std::string ellipses_csv(const std::vector<EllipseFinding>& cases) {
  CsvWriter csv;
  for (const auto& column : case_columns) csv.text(column.heading);
  for (const auto& column : ray_columns) csv.text(column.heading);
  csv.end_row();
  for (const EllipseFinding& item : cases)
    for (const RayFinding& rays : item.rays) {
      add_fields(item, case_columns, csv);
      add_fields(rays, ray_columns, csv);
      csv.end_row();
    }
  return csv.table();
}

}  // namespace sturm
