#include "io/specs/lens_files/vca_file.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/specs/lens_files/vca_records.h"
#include "io/specs/sag_grid.h"
#include "lensmodel/power_matrix.h"
#include "lensmodel/single_vision.h"
#include "lensmodel/units.h"
#include "lensmodel/vertex_power.h"

namespace sturm {

namespace {

constexpr double usual_tooling_index = 1.53;  // curves in dioptres are stated for it unless TIND says otherwise
constexpr double noticeable_D = 0.12;         // as standards allow a finished lens to differ

const std::vector<std::string_view> used_labels{"SPH",   "CYL",   "AX",  "ADD",  "PRVM",   "PRVA",
                                                "PRVIN", "PRVUP", "DIA", "LIND", "CTHICK", "FRNT",
                                                "BACK",  "TIND",  "DO",  "JOB",  "REQ",    "ANS"};

std::string eye_name(EyeSide eye) {
  return eye == EyeSide::right ? "right" : "left";
}

EyeSide eye_of(const VcaRecords& records, const LensFileRequest& request) {
  const std::vector<EyeSide> eyes = records.eyes();
  if (request.eye && records.has("DO") && eyes.size() == 1 && eyes[0] != *request.eye)
    records.fail("DO", "a job for the other eye alone", "the " + eye_name(*request.eye) + " eye");
  if (request.eye) return *request.eye;
  if (eyes.size() > 1)
    throw InputError(request.file, "", "a job for both eyes", "\"eye\": \"right\" or \"left\" beside \"file\"");
  return eyes.empty() ? EyeSide::right : eyes[0];
}

/// The lens under construction.
class VcaBuilder {
 public:
  VcaBuilder(const VcaRecords& records, const LensFileRequest& request)
      : records_(records), request_(request), eye_(eye_of(records, request)) {}

  LensFile run() {
    read_numbers();
    read_prescription();
    const std::optional<double> front_D = curve("FRNT");
    const VcaMatrix *front = records_.matrix(true, eye_), *back = records_.matrix(false, eye_);
    if (!result_.made_for) {
      if (!front && !front_D) missing("FRNT");
      if (!back && !records_.number("BACK", eye_)) missing("BACK");
    }
    if (result_.made_for) make_from_prescription(front_D);
    if (front)
      result_.lens.front = surface(*front, "front");
    else if (front_D)
      result_.lens.front = SphereSurface{*front_D / (result_.lens.refractive_index - 1.0)};
    if (back) {
      result_.lens.back = surface(*back, "back");
      result_.prism_cm_per_m = 0.0;  // it is in the heights
    }
    if (!back && !result_.made_for)
      // A hollow back, however its sign is written.
      result_.lens.back = SphereSurface{std::abs(curve("BACK").value()) / (result_.lens.refractive_index - 1.0)};
    add_notes(front || back);
    return std::move(result_);
  }

 private:
  std::optional<double> number(const char* label) const { return records_.number(label, eye_); }

  [[noreturn]] void missing(const char* label) const {
    throw InputError(request_.file, "", "no " + std::string(label) + " for the " + eye_name(eye_) + " eye",
                     "SPH with its CYL and AX, or both surfaces: FRNT or a SURFMT for F, and BACK or a SURFMT for B");
  }

  double in_range(const char* label, double value, double least, double most) const {
    if (!(value >= least && value <= most))
      records_.fail(label, std::string(label) + "=" + plain_number(value, 12),
                    "from " + plain_number(least) + " to " + plain_number(most));
    return value;
  }

  /// Power of a surface in the lens's own index [D], from a curve stated for the tooling index.
  std::optional<double> curve(const char* label) const {
    const auto stated = number(label);
    if (!stated) return std::nullopt;
    const double tooling = in_range("TIND", number("TIND").value_or(usual_tooling_index), 1.1, 4.0);
    return in_range(label, *stated, -40.0, 40.0) * (result_.lens.refractive_index - 1.0) / (tooling - 1.0);
  }

  void read_numbers() {
    Spectacles& lens = result_.lens;
    if (request_.refractive_index)
      lens.refractive_index = *request_.refractive_index;
    else if (const auto index = number("LIND"))
      lens.refractive_index = in_range("LIND", *index, 1.1, 4.0);
    else
      throw InputError(request_.file, "", "no LIND", "the lens's index, LIND, or \"refractive_index\" beside \"file\"");
    if (request_.center_thickness_m)
      lens.center_thickness_m = *request_.center_thickness_m;
    else if (const auto thickness = number("CTHICK"))
      lens.center_thickness_m = metres_per_millimetre * in_range("CTHICK", *thickness, 0.01, 50.0);
    else
      throw InputError(request_.file, "", "no CTHICK",
                       "the lens's thickness, CTHICK, or \"center_thickness_mm\" beside \"file\"");
    if (request_.diameter_m)
      lens.diameter_m = *request_.diameter_m;
    else if (const auto diameter = number("DIA"))
      lens.diameter_m = metres_per_millimetre * in_range("DIA", *diameter, 1.0, 200.0);
    else
      note(assumed_diameter("DIA", lens.diameter_m));
  }

  void read_prescription() {
    const auto sphere = number("SPH");
    if (!sphere) return;
    Prescription rx;
    rx.sphere_D = in_range("SPH", *sphere, -40.0, 40.0);
    rx.cylinder_D = in_range("CYL", number("CYL").value_or(0.0), -40.0, 40.0);
    const auto axis = number("AX");
    if (rx.cylinder_D != 0.0 && !axis) records_.fail("CYL", "no AX", "the axis of the cylinder, AX");
    rx.axis_deg = in_range("AX", axis.value_or(180.0), 0.0, 180.0);
    read_prism(rx);
    result_.made_for = rx;
  }

  /// PRVM at PRVA, or PRVIN (base in) and PRVUP (base up).
  void read_prism(Prescription& rx) const {
    if (const auto amount = number("PRVM"); amount && *amount != 0.0) {
      const auto base = number("PRVA");
      if (!base) records_.fail("PRVM", "no PRVA", "the base of the prism, PRVA [deg]");
      rx.prism_cm_per_m = in_range("PRVM", *amount, 0.0, 40.0);
      rx.prism_base_deg = in_range("PRVA", *base, 0.0, 360.0);
      return;
    }
    // The nose is on the examiner's right of a right eye.
    const double in = number("PRVIN").value_or(0.0), right = eye_ == EyeSide::right ? in : -in;
    const double up = number("PRVUP").value_or(0.0);
    if (right == 0.0 && up == 0.0) return;
    rx.prism_cm_per_m = in_range("PRVIN", std::hypot(right, up), 0.0, 40.0);
    const double base = std::atan2(up, right) * 180.0 / std::numbers::pi;
    rx.prism_base_deg = base < 0.0 ? base + 360.0 : base;
  }

  /// The back that gives the lens its power behind the front that is stated, or else usual.
  void make_from_prescription(std::optional<double> front_D) {
    SingleVisionDesign design;
    design.base_curve_D = front_D;
    design.center_thickness_m = result_.lens.center_thickness_m;
    design.refractive_index = result_.lens.refractive_index;
    design.diameter_m = result_.lens.diameter_m;
    Prescription power = *result_.made_for;
    power.prism_cm_per_m = 0.0;  // the document's mounting comes first
    result_.prism_cm_per_m = result_.made_for->prism_cm_per_m,
    result_.prism_base_deg = result_.made_for->prism_base_deg;
    try {
      result_.lens = single_vision(power, design);
    } catch (const std::logic_error& error) {  // std::invalid_argument, std::domain_error
      throw InputError(request_.file, "", error.what(), "a lens that can be made");
    }
  }

  /// x to the right as the examiner sees it and rows from the top; heights towards the eye.
  Surface surface(const VcaMatrix& matrix, const char* side) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < matrix.heights_mm.size(); ++i) {
      if (!matrix.heights_mm[i]) continue;
      const int row = static_cast<int>(i) / matrix.columns, column = static_cast<int>(i) % matrix.columns;
      points.push_back(metres_per_millimetre *
                       Eigen::Vector3d(matrix.width_mm * (0.5 - column / (matrix.columns - 1.0)),
                                       matrix.height_mm * (0.5 - row / (matrix.rows - 1.0)), *matrix.heights_mm[i]));
    }
    const SagGrid grid = sag_surface(points, std::nullopt, 0.5 * result_.lens.diameter_m, request_.file);
    result_.fits.push_back({side, grid.surface.grid().spacing, grid.residual, std::nullopt});
    return grid.surface;
  }

  void note(const std::string& text) { result_.notes.push_back(request_.file + ": " + text); }

  void add_notes(bool has_matrix) {
    for (const std::string& label : records_.repeated()) note("of several records " + label + " the last one counts");
    if (const auto labels = records_.others(used_labels); !labels.empty()) {
      std::string list;
      for (std::size_t i = 0; i < labels.size() && i < 40; ++i) list += (i ? ", " : "") + labels[i];
      note("these records do not count: " + list + (labels.size() > 40 ? ", …" : ""));
    }
    if (const auto addition = number("ADD"); addition && *addition != 0.0 && !has_matrix)
      note("the addition of " + plain_number(*addition) + " D is not made: the file has no heights of a surface");
    if (result_.made_for && !number("FRNT") && !records_.matrix(true, eye_))
      note("it has no FRNT; the front is the usual one for its power");
    const auto back = number("BACK");
    if (result_.made_for && back && !records_.matrix(false, eye_))
      note("BACK does not count: SPH, CYL and AX make the back");
    note_of_power();
  }

  /// Surfaces that do not have the power which the file states.
  void note_of_power() {
    if (!result_.made_for) return;
    const auto power = vertex_power(result_.lens).back_vertex;
    if (!power) return;
    Prescription rx = *result_.made_for;
    rx.vertex_distance_m = 0.0;
    const double difference = (power->matrix() - PowerMatrix::from(rx).matrix()).norm();
    if (difference > noticeable_D)
      note("at its centre the lens has " + plain_number(power->as_prescription().sphere_D, 4) + " " +
           plain_number(power->as_prescription().cylinder_D, 4) + " x " +
           plain_number(power->as_prescription().axis_deg, 4) + ", not what SPH, CYL and AX say");
  }

  const VcaRecords& records_;
  const LensFileRequest& request_;
  EyeSide eye_;
  LensFile result_;
};

}  // namespace

LensFile vca_lens(std::string_view text, const LensFileRequest& request) {
  const VcaRecords records(text, request.file);
  return VcaBuilder(records, request).run();
}

}  // namespace sturm
