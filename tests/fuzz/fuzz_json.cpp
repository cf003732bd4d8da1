#include <nlohmann/json.hpp>

#include "io/json/json.h"
#include "tests/fuzz/reader_under_test.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] { sturm::parse_json(text_of(data, size), "fuzzed.json"); });
  return 0;
}
