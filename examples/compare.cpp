// By how much do two pictures differ? All metrics of `sturm compare`.
#include <sturm/compare/images/picture_comparison.h>
#include <sturm/io/images/picture_file.h>

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const auto test = sturm::read_picture_file(argv[1]), reference = sturm::read_picture_file(argv[2]);
  const auto result = sturm::compare_pictures(test.image(), reference.image(), {}, {});
  for (const auto& metric : result.metrics)
    if (metric.value) std::printf("%-24s %.17g\n", metric.key.c_str(), *metric.value);
}
