#include "tests/fuzz/model_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  sturm::fuzz::read_model("ply", sturm::fuzz::text_of(data, size));
  return 0;
}
