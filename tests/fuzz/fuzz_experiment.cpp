#include <nlohmann/json.hpp>

#include "io/json/schema.h"
#include "io/specs/experiment/experiment_spec.h"
#include "tests/fuzz/reader_under_test.h"

/// A document with a format of Sturm's: its schema, then its reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] {
    sturm::read_experiment(sturm::parse_json(text_of(data, size), "fuzzed.json"), (folder() / "fuzzed.json").string());
  });
  return 0;
}
