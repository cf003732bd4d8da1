#include "io/images/upright.h"

#include <algorithm>

namespace sturm {

Image upright(Image stored, int orientation) {
  if (orientation < 2 || orientation > 8) return stored;
  const bool swapped = orientation >= 5;
  const int turn = (orientation - 1) % 4;  // which sides the first row and the first column are at
  const bool from_right = turn == 1 || turn == 2, from_bottom = turn >= 2;
  Image seen(swapped ? stored.height : stored.width, swapped ? stored.width : stored.height, stored.channels);
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      const int along = from_right ? seen.width - 1 - x : x, down = from_bottom ? seen.height - 1 - y : y;
      std::copy_n(swapped ? stored.at(down, along) : stored.at(along, down), stored.channels, seen.at(x, y));
    }
  return seen;
}

}  // namespace sturm
