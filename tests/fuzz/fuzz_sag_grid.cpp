#include "io/specs/sag_grid.h"
#include "tests/fuzz/reader_under_test.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] { sturm::read_sag_grid(written("sag.csv", text_of(data, size)).string(), std::nullopt, 0.01); });
  return 0;
}
