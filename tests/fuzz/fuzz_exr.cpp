#include "io/images/exr.h"
#include "tests/fuzz/reader_under_test.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] { sturm::read_exr(written("fuzzed.exr", text_of(data, size)), std::size_t{64} << 20); });
  return 0;
}
