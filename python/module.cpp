#include "io/files/build_info.h"
#include "python/bindings.h"

PYBIND11_MODULE(_core, module) {
  using namespace sturm;
  module.doc() = "The C++ side of sturm: everything is computed here, by the functions that the command line calls.";
  module.attr("__version__") = std::string(build_info().version);
  module.attr("__commit__") = std::string(build_info().commit);
  bind_errors(module);
  bind_documents(module);
  bind_prescriptions(module);
  bind_eyes(module);
  bind_lenses(module);
  bind_ellipses(module);
  bind_wavefronts(module);
  bind_point_spreads(module);
  bind_blur_fields(module);
  bind_pictures(module);
  bind_seen_pictures(module);
  bind_metrics(module);
  bind_gates(module);
}
