#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/images/exr.h"
#include "io/images/picture_file.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/json_objects.h"
#include "python/watched_work.h"
#include "stages/image_files.h"
#include "stages/render_stage.h"

namespace sturm {

namespace {

py::tuple rendered(const py::object& document, const std::string& file, const py::object& progress) {
  const GivenDocument given = given_document(document, file);
  std::optional<RenderSpec> spec;
  std::optional<RenderOutput> output;
  do_watched(progress, [&](const ProgressFunction& report) {
    spec = read_render_spec(given.document, given.file);
    output = render_view(*spec, report);
  });
  py::dict layers;
  for (auto& [name, image] : output->image.layers) layers[py::str(name)] = array_of(std::move(image));
  return py::make_tuple(layers, object_from(output->counters), output->seconds, output->notes,
                        object_from(*spec->resolved));
}

py::array read(const std::filesystem::path& file, const std::optional<std::string>& layer) {
  PictureFile picture = read_picture_file(file, layer);
  make_linear(picture);
  return array_of(std::move(picture.picture.layers.at("")));
}

void write(const std::filesystem::path& file, const py::object& picture, double exposure) {
  Image image = image_of(picture, "picture", 3);
  if (image.channels != 3) throw InputError("", "picture", std::to_string(image.channels) + " channels", "3 channels");
  if (has_suffix(file, ".exr"))
    write_exr(file, LayeredImage{{{"", std::move(image)}}, {}});
  else if (has_suffix(file, ".png"))
    write_png(file, image, exposure);
  else
    throw InputError("", "file", "\"" + file.string() + "\"", "a name that ends in .exr or .png");
}

}  // namespace

void bind_pictures(py::module_& module) {
  using namespace pybind11::literals;
  module.def(
      "render", &rendered, "document"_a, "file"_a = "", "progress"_a = py::none(),
      "Renders a document of format sturm.render/1: layers, counters, seconds, notes, and the document with its\n"
      "defaults.");
  module.def(
      "read_picture", &read, "file"_a, "layer"_a = py::none(),
      "Reads a picture (EXR, HDR, PFM, PNG, JPEG, TIFF, ...) as an array of float32 in linear light, height x width x\n"
      "3 or 4 channels, row 0 at the top; what is for a display is decoded (sRGB). `layer` names one of an EXR.");
  module.def("write_picture", &write, "file"_a, "picture"_a, "exposure"_a = 1.0,
             "Writes an array (height x width x 3, linear light) as EXR, or for a display as PNG: exposure times the\n"
             "light, clamped, sRGB.");
}

}  // namespace sturm
