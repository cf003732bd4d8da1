#include <nlohmann/json.hpp>

#include "io/json/schema.h"
#include "io/specs/experiment/experiment_spec.h"
#include "tests/fuzz/reader_under_test.h"

/// A document of Sturm's: its schema, then its reader.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] {
    const std::string file = (folder() / "fuzzed.json").string();
    const sturm::Json document = sturm::parse_json(text_of(data, size), file);
    sturm::validate(document, "experiment", file);
    sturm::read_experiment(document, file);
  });
  return 0;
}
