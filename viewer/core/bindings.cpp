#include <emscripten/bind.h>

#include <string>

#include "conoid/pictures/pupil_passes.h"
#include "io/specs/notation_parser.h"
#include "io/specs/noted_prism.h"
#include "lensmodel/accommodation.h"
#include "lensmodel/units.h"
#include "viewer/core/errors.h"
#include "viewer/core/optics.h"
#include "viewer/core/to_js.h"

namespace sturm::viewer {

using emscripten::val;

namespace {

void append(std::vector<float>& numbers, const std::vector<PupilPass>& passes) {
  for (const PupilPass& pass : passes)
    numbers.insert(numbers.end(), {pass.pupil.x(), pass.pupil.y(), pass.film.x(), pass.film.y()});
}

val passes(int count, double turn) {
  std::vector<float> numbers;
  append(numbers, pupil_passes(count, turn));
  return copy_of(numbers);
}

val interleaved(int count) {
  std::vector<float> numbers;
  for (const auto& set : interleaved_passes(count)) append(numbers, set);
  return copy_of(numbers);
}

val noted_of(const NotedPrescription& rx) {
  if (rx.prism_nasal != 0.0 && !rx.eye)
    throw NotationError("OD or OS before a prism with its base in or out, which lies on either side of the two eyes");
  const Prism prism = prism_of(rx);
  val numbers = val::object();
  numbers.set("sphere_D", rx.sphere_D);
  numbers.set("cylinder_D", rx.cylinder_D);
  numbers.set("axis_deg", rx.axis_deg.value_or(180.0));
  numbers.set("vertex_distance_m", metres_per_millimetre * rx.vertex_distance_mm.value_or(12.0));
  numbers.set("prism_cm_per_m", prism.cm_per_m);
  numbers.set("prism_base_deg", prism.base_deg);
  val result = val::object();
  result.set("eye", rx.eye ? val(std::string(*rx.eye == EyeSide::right ? "right" : "left")) : val::null());
  result.set("prescription", numbers);
  result.set("vertex_distance_m",
             rx.vertex_distance_mm ? val(metres_per_millimetre * *rx.vertex_distance_mm) : val::null());
  result.set("addition_D", number_or_null(rx.addition_D));
  return result;
}

val notation(const std::string& text) {
  val list = val::array();
  for (const NotedPrescription& rx : NotationParser(notation_tokens(text)).run()) list.call<void>("push", noted_of(rx));
  return list;
}

}  // namespace

EMSCRIPTEN_BINDINGS(sturm_core) {
  emscripten::class_<Optics>("Optics")
      .constructor<>()
      .function("setEye", telling<&Optics::set_eye>())
      .function("setLens", telling<&Optics::set_lens>())
      .function("correction", telling<&Optics::correction>())
      .function("frontSpline", telling<&Optics::front_spline>())
      .function("accommodation", telling<&Optics::accommodation>())
      .function("wavefrontSlopes", telling<&Optics::wavefront_slopes>())
      .function("fieldAnalytic", telling<&Optics::field_analytic>())
      .function("fieldVoxels", telling<&Optics::field_voxels>())
      .function("ellipse", telling<&Optics::ellipse>())
      .function("errors", telling<&Optics::errors>())
      .function("clearVision", telling<&Optics::clear_vision>())
      .function("gazeAt", telling<&Optics::gaze_at>())
      .function("pictureEllipse", telling<&Optics::picture_ellipse>())
      .function("sights", telling<&Optics::sights>())
      .function("pixelRays", telling<&Optics::pixel_rays>())
      .function("rayModel", telling<&Optics::ray_model>());
  emscripten::function("pupilPasses", &passes);
  emscripten::function("interleavedPasses", &interleaved);
  emscripten::function("readNotation", telling<&notation>());
  emscripten::function("amplitudeAtAge", &hofstetter_amplitude);
}

}  // namespace sturm::viewer
