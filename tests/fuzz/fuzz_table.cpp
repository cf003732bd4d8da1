#include "io/specs/prescription_table.h"
#include "tests/fuzz/reader_under_test.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] { sturm::read_prescription_table(written("eyes.csv", text_of(data, size)), 0.012); });
  return 0;
}
