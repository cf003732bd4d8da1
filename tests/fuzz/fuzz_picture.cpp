#include <span>

#include "io/images/image_formats.h"
#include "tests/fuzz/reader_under_test.h"

/// PNG, JPEG, Radiance HDR, PFM and whatever else the module reads, as their content says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] { sturm::read_embedded_image(std::span<const unsigned char>(data, size), "fuzzed"); });
  return 0;
}
