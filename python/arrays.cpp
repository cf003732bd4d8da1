#include "python/arrays.h"

#include <algorithm>

#include "io/files/error.h"

namespace sturm {

namespace py = pybind11;

py::array array_of(Image&& image) {
  const auto [picture, owner] = kept(std::move(image));
  std::vector<py::ssize_t> shape{picture->height, picture->width};
  if (picture->channels != 1) shape.push_back(picture->channels);
  return py::array_t<float>(shape, picture->pixels.data(), owner);
}

Image image_of(const py::handle& object, const char* name, int most_channels) {
  const auto array = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(object);
  if (!array) PyErr_Clear();
  const bool flat = array && array.ndim() == 2;
  if (!array || (!flat && array.ndim() != 3) || array.size() == 0 || (!flat && array.shape(2) > most_channels))
    throw InputError(
        "", name,
        array ? "an array of shape " + py::str(array.attr("shape")).cast<std::string>()
              : py::repr(object).cast<std::string>(),
        "an array of numbers, height × width × channels, of at most " + std::to_string(most_channels) + " channels");
  Image image(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)),
              flat ? 1 : static_cast<int>(array.shape(2)));
  std::copy_n(array.data(), image.pixels.size(), image.pixels.begin());
  return image;
}

}  // namespace sturm
