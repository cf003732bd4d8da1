#include "compare/studies/lens/lens_findings.h"

namespace sturm {

template <>
inline constexpr auto record_members<LensStudyConditions> =
    std::tuple{member("radial", &LensStudyConditions::radial), member("azimuthal", &LensStudyConditions::azimuthal),
               member("order_pupils_mm", &LensStudyConditions::order_pupils_mm),
               member("rotation_center_mm", &LensStudyConditions::rotation_center_mm)};

template <>
inline constexpr auto record_members<LensFacts> =
    std::tuple{member("id", &LensFacts::id),
               member("note", &LensFacts::note),
               member("lens_of_revolution", &LensFacts::lens_of_revolution),
               member("analytic_surfaces", &LensFacts::analytic_surfaces),
               member("sphere_D", &LensFacts::sphere_D),
               member("cylinder_D", &LensFacts::cylinder_D),
               member("axis_deg", &LensFacts::axis_deg),
               member("vertex_distance_mm", &LensFacts::vertex_distance_mm)};

template <>
inline constexpr auto record_members<Eq11Outcome> =
    std::tuple{member("principal", &Eq11Outcome::principal), member("incidence", &Eq11Outcome::incidence)};

template <>
inline constexpr auto record_members<LensGaze> = std::tuple{member("lens", &LensGaze::lens),
                                                            member("eccentricity_deg", &LensGaze::eccentricity_deg),
                                                            member("direction_deg", &LensGaze::direction_deg),
                                                            member("gaze_deg", &LensGaze::gaze_deg),
                                                            member("status", &LensGaze::status),
                                                            member("eq11", &LensGaze::eq11)};

template <>
inline constexpr auto record_members<FirstOrderError> =
    std::tuple{member("relative_frobenius", &FirstOrderError::relative_frobenius),
               member("defocus_D", &FirstOrderError::defocus_D)};

template <>
inline constexpr auto record_members<FirstOrderErrors> =
    std::tuple{member("published", &FirstOrderErrors::published), member("previous", &FirstOrderErrors::previous)};

template <>
inline constexpr auto record_members<MethodError> = std::tuple{
    member("relative_frobenius", &MethodError::relative_frobenius),
    member("semi_axes_arcmin", &MethodError::semi_axes_arcmin),
    member("half_width_arcmin", &MethodError::half_width_arcmin), member("defocus_D", &MethodError::defocus_D)};

template <>
inline constexpr auto record_members<LensPupil> =
    std::tuple{member("pupil_mm", &LensPupil::pupil_mm),
               member("rays_lost", &LensPupil::rays_lost),
               member("real_semi_axes_arcmin", &LensPupil::real_semi_axes_arcmin),
               member("ray_transfer", &LensPupil::ray_transfer),
               member("published", &LensPupil::published),
               member("previous", &LensPupil::previous)};

template <>
inline constexpr auto record_members<MutantOrders> =
    std::tuple{member("published_as_exact", &MutantOrders::published_as_exact),
               member("mirrored_gaze", &MutantOrders::mirrored_gaze)};

template <>
inline constexpr auto record_members<LensStudyView> =
    std::tuple{member("lens", &LensStudyView::lens),
               member("eccentricity_deg", &LensStudyView::eccentricity_deg),
               member("direction_deg", &LensStudyView::direction_deg),
               member("distance_m", &LensStudyView::distance_m),
               member("blur_D", &LensStudyView::blur_D),
               member("first_order", &LensStudyView::first_order),
               member("previous_unscaled_error", &LensStudyView::previous_unscaled_error),
               member("order", &LensStudyView::order),
               member("relative_order", &LensStudyView::relative_order),
               member("limit_relative", &LensStudyView::limit_relative),
               member("mutant_orders", &LensStudyView::mutant_orders),
               member("pupils", &LensStudyView::pupils)};

template <>
inline constexpr auto record_members<FieldEllipse> =
    std::tuple{member("semi_axes_arcmin", &FieldEllipse::semi_axes_arcmin),
               member("orientation_deg", &FieldEllipse::orientation_deg)};

template <>
inline constexpr auto record_members<FieldPoint> =
    std::tuple{member("azimuth_deg", &FieldPoint::azimuth_deg), member("status", &FieldPoint::status),
               member("real_rays", &FieldPoint::real_rays),     member("ray_transfer", &FieldPoint::ray_transfer),
               member("published", &FieldPoint::published),     member("previous", &FieldPoint::previous)};

template <>
inline constexpr auto record_members<LensField> =
    std::tuple{member("lens", &LensField::lens), member("distance_m", &LensField::distance_m),
               member("pupil_mm", &LensField::pupil_mm), member("points", &LensField::points)};

template <>
inline constexpr auto record_members<LensFindings> =
    std::tuple{member("conditions", &LensFindings::conditions), member("lenses", &LensFindings::lenses),
               member("gazes", &LensFindings::gazes), member("views", &LensFindings::views),
               member("field", &LensFindings::field)};

template <>
inline constexpr auto record_members<LensPart> =
    std::tuple{member("lens", &LensPart::lens), member("gazes", &LensPart::gazes), member("views", &LensPart::views)};

Json to_json(const LensFindings& findings) {
  return json_from(findings);
}

std::optional<LensFindings> lens_findings(const Json& report) {
  return record_from<std::optional<LensFindings>>(value_at(report, "lens_study"));
}

Json to_json(const LensPart& part) {
  return json_from(part);
}

LensPart lens_part_from(const Json& json) {
  return record_from<LensPart>(json);
}

Json to_json(const LensField& field) {
  return json_from(field);
}

LensField lens_field_from(const Json& json) {
  return record_from<LensField>(json);
}

}  // namespace sturm
