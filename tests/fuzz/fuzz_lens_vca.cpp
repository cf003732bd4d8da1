#include "io/specs/lens_files/lens_file.h"
#include "tests/fuzz/reader_under_test.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  sturm::LensFileRequest request;
  request.file = written("lens.oma", text_of(data, size)).string();
  request.eye = sturm::EyeSide::right;
  try_reader([&] { sturm::read_lens_file(request); });
  return 0;
}
