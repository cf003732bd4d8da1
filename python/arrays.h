#pragma once
#include <pybind11/numpy.h>

#include <memory>
#include <utility>

#include "io/images/image.h"

namespace sturm {

/// A picture as an array of height × width × channels floats, or height × width for one channel, row 0 at the top. The
/// array has the picture's own memory; nothing is copied.
pybind11::array array_of(Image&& image);

/// A copy of an array of float32 (or what converts to it) of height × width, or height × width × channels, of at most
/// `most_channels`. `name` is for errors. Throws InputError.
Image image_of(const pybind11::handle& array, const char* name, int most_channels);

/// Gives `value` to Python for as long as an array that looks at it lives.
template <class Value>
std::pair<Value*, pybind11::capsule> kept(Value&& value) {
  auto owner = std::make_unique<Value>(std::forward<Value>(value));
  Value* kept_value = owner.get();
  pybind11::capsule capsule(owner.get(), [](void* held) { delete static_cast<Value*>(held); });
  owner.release();
  return {kept_value, std::move(capsule)};
}

}  // namespace sturm
