#include "io/images/picture_file.h"
#include "tests/fuzz/reader_under_test.h"

/// PNG, JPEG, Radiance HDR, PFM, EXR and whatever else is read: the content decides.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] { sturm::read_picture_file(written("fuzzed", text_of(data, size))); });
  return 0;
}
