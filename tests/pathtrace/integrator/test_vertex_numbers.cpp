#include <gtest/gtest.h>

#include "pathtrace/integrator/vertex_numbers.h"

namespace sturm {
namespace {

/// Dimensions 2 + 3·bounce: scatter, light, roulette, written out here so that no path may move to other numbers
/// unnoticed.
void expect_sequence_itself(Sequence kind, std::uint32_t count = 16) {
  const PixelSequence sequence(kind, 7, 1234);
  VertexNumbers numbers(sequence);
  for (std::uint32_t first : {0u, 16u, 4080u}) {
    numbers.begin_block(first, static_cast<int>(count));
    for (std::uint32_t sample : {first + count / 3, first, first + count - 1})
      for (std::uint32_t bounce : {0u, 3u, 1u, 9u, 10u, 40u}) {  // the table ends somewhere on the way
        const auto light = sequence.pair(sample, 2 + 3 * bounce + 1), scatter = sequence.pair(sample, 2 + 3 * bounce);
        const LocalDirection expected = cosine_local(unit_float(scatter.x), unit_float(scatter.y));
        const VertexNumbers::Vertex got = numbers.vertex(sample, static_cast<int>(bounce));
        // Bit for bit: a picture must not depend on which way its numbers were made.
        EXPECT_EQ(got.light_u, unit_float(light.x)) << sample << ", " << bounce;
        EXPECT_EQ(got.light_v, unit_float(light.y)) << sample << ", " << bounce;
        EXPECT_EQ(got.scatter.x, expected.x) << sample << ", " << bounce;
        EXPECT_EQ(got.scatter.y, expected.y) << sample << ", " << bounce;
        EXPECT_EQ(got.scatter.z, expected.z) << sample << ", " << bounce;
        EXPECT_EQ(numbers.survive(sample, static_cast<int>(bounce)),
                  unit_float(sequence.single(sample, 2 + 3 * bounce + 2)));
      }
  }
}

TEST(VertexNumbers, SobolInBlocksHasTheBitsOfTheSequence) {
  for (std::uint32_t count : {16u, 9u, 8u, 1u}) expect_sequence_itself(Sequence::Sobol, count);
}

TEST(VertexNumbers, OtherSequencesComeThroughUnchanged) {
  expect_sequence_itself(Sequence::Halton);
  const PixelSequence halton(Sequence::Halton, 7, 1234), sobol(Sequence::Sobol, 7, 1234);
  EXPECT_NE(VertexNumbers(halton).vertex(3, 1).light_u, VertexNumbers(sobol).vertex(3, 1).light_u);
}

}  // namespace
}  // namespace sturm
