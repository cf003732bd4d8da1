#include <nlohmann/json.hpp>

#include "io/specs/experiment/experiment_spec.h"
#include "tests/fuzz/reader_under_test.h"

/// A document of Sturm's; its reader holds it against the schema first.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sturm::fuzz;
  try_reader([&] {
    const std::string file = (folder() / "fuzzed.json").string();
    sturm::read_experiment(sturm::parse_json(text_of(data, size), file), file);
  });
  return 0;
}
