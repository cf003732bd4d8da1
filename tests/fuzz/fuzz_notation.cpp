#include "io/specs/notation_tokens.h"
#include "io/specs/prescription_notation.h"
#include "tests/fuzz/reader_under_test.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    for (const sturm::NotedPrescription& rx : sturm::parse_prescription_notation(sturm::fuzz::text_of(data, size)))
      sturm::parse_prescription_notation(sturm::in_notation(rx));  // what is printed reads back
  } catch (const sturm::NotationError&) {
  }
  return 0;
}
