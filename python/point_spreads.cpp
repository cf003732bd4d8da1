#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "lensmodel/units.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/json_objects.h"
#include "stages/psf_stage.h"

namespace sturm {

namespace {

/// The share of the energy in each pixel, row 0 at the top: the memory of the cells, whose rows ascend, read backwards.
py::array picture_of(PsfCells&& cells) {
  const auto [held, owner] = kept(std::move(cells.energy));
  const py::ssize_t side = held->rows(), number = sizeof(double);
  return py::array_t<double>({side, held->cols()}, {-number, held->outerStride() * number}, held->data() + (side - 1),
                             owner);
}

py::tuple point_spreads_of(const py::object& query, const std::string& file) {
  const GivenDocument given = given_document(query, file);
  PointSpreads spreads;
  Json result;
  {
    const py::gil_scoped_release release;
    const PsfSpec spec = read_psf_spec(given.document, given.file);
    spreads = point_spreads(spec, given.file);
    result = psf_result(spec, spreads);
  }
  py::list pictures;
  for (MeasuredSpread& spread : spreads.spreads) {
    const double pixel_arcmin = arcminutes_per_radian * spread.picture.cell_rad;
    pictures.append(py::make_tuple(picture_of(std::move(spread.picture)), pixel_arcmin));
  }
  return py::make_tuple(object_from(result), pictures);
}

}  // namespace

void bind_point_spreads(py::module_& module) {
  using namespace pybind11::literals;
  module.def(
      "point_spreads", &point_spreads_of, "query"_a, "file"_a = "",
      "Answers a query of format sturm.psf/1: sturm.psf_result/1, and for each of its spreads a picture with the\n"
      "side of its pixels [arcmin].");
}

}  // namespace sturm
