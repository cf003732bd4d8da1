#include <gtest/gtest.h>

#include <string>

#include "io/files/error.h"
#include "io/files/gzip.h"

namespace sturm {
namespace {

TEST(Gzip, ComesBackAsItWas) {
  std::string bytes;
  for (int k = 0; k < 300000; ++k) bytes += static_cast<char>(static_cast<long long>(k) * k / 7);
  for (const std::string& text : {std::string(), std::string("a\0b", 3), bytes}) {
    const std::string file = gzip(text);
    EXPECT_EQ(file.substr(0, 2), "\x1f\x8b");
    EXPECT_EQ(gunzip(file), text);
    EXPECT_EQ(file, gzip(text));
  }
  EXPECT_LT(gzip(std::string(100000, 'x')).size(), 1000u);
}

TEST(Gzip, RefusesWhatIsNone) {
  const std::string file = gzip("some text that is long enough");
  EXPECT_THROW(gunzip(file.substr(0, file.size() - 6)), RuntimeFailure);
  EXPECT_THROW(gunzip("no gzip file"), RuntimeFailure);
  EXPECT_THROW(gunzip(""), RuntimeFailure);
}

}  // namespace
}  // namespace sturm
