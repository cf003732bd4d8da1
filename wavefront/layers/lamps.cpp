#include "wavefront/layers/lamps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>

#include "wavefront/layers/brightness.h"
#include "wavefront/layers/outshone_colours.h"

namespace sturm {

namespace {

constexpr float brighter = 20.0f;
constexpr int surroundings = 8;  // [px]: lamps that are larger have a core that is blurred like any surface

struct SurfacePart {
  float* rgb;
  double vergence_D;
  float coverage;
};

struct Found {
  float* rgb;  // of the pixel that it is taken from
  Detail* detail;
  std::array<float, 3> whole;  // its colour with the lamp
  HiddenPixel left;            // the pixel without it
  LampPixel lamp;              // without its light
};

class LampSearch {
 public:
  LampSearch(LayeredPicture& picture, float level)
      : picture_(picture),
        width_(picture.radiance.width),
        height_(picture.radiance.height),
        level_(level),
        seen_(picture.vergence_D.size(), false) {}

  void search() {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x)
        if (brightness_of(picture_.radiance.at(x, y)) > level_) examine_about(x, y);
    for (HiddenPixel& hidden : picture_.hidden) {
      const SurfacePart piece{hidden.rgb, hidden.vergence_D, hidden.coverage};
      if (brightness_of(hidden.rgb) > level_ || is_rim(hidden.x, hidden.y, piece))
        examine(hidden.x, hidden.y, piece, &hidden.detail);
    }
  }

  void take() {
    for (const Found& found : found_) {
      std::copy_n(found.left.rgb, 3, found.rgb);
      if (found.detail) *found.detail = {};
    }
    guess_what_is_left();
    for (Found& found : found_) {
      for (int c = 0; c < 3; ++c) {
        found.rgb[c] = std::min(found.rgb[c], found.whole[c]);
        found.lamp.rgb[c] = found.left.coverage * (found.whole[c] - found.rgb[c]);
      }
      picture_.lamps.push_back(found.lamp);
    }
    std::stable_sort(picture_.lamps.begin(), picture_.lamps.end(),
                     [](const LampPixel& a, const LampPixel& b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
  }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  bool same(double a, double b) const { return std::abs(a - b) <= picture_.jump_D; }

  SurfacePart front(int x, int y) const {
    return {picture_.radiance.at(x, y), picture_.vergence_D[index(x, y)],
            picture_.coverage.empty() ? 1.0f : picture_.coverage[index(x, y)]};
  }

  /// What there is of a surface in a pixel.
  std::optional<SurfacePart> piece_of(int x, int y, double vergence_D) const {
    if (const SurfacePart piece = front(x, y); same(piece.vergence_D, vergence_D) && piece.coverage > 0.0f)
      return piece;
    auto hidden = std::lower_bound(picture_.hidden.begin(), picture_.hidden.end(), std::pair(y, x),
                                   [](const HiddenPixel& h, const auto& at) { return std::pair(h.y, h.x) < at; });
    for (; hidden != picture_.hidden.end() && hidden->x == x && hidden->y == y; ++hidden)
      if (same(hidden->vergence_D, vergence_D)) return SurfacePart{hidden->rgb, hidden->vergence_D, hidden->coverage};
    return std::nullopt;
  }

  template <class Visit>
  void around(int x, int y, int distance, Visit visit) const {
    for (int v = std::max(0, y - distance); v <= std::min(height_ - 1, y + distance); ++v)
      for (int u = std::max(0, x - distance); u <= std::min(width_ - 1, x + distance); ++u) visit(u, v);
  }

  bool beside_an_edge(int x, int y) const {
    bool edge = false;
    const double here = picture_.vergence_D[index(x, y)];
    around(x, y, 1, [&](int u, int v) { edge |= !same(picture_.vergence_D[index(u, v)], here); });
    return edge;
  }

  /// The mean colour of the darker half of what is no brighter than `limit` about a piece on its surface.
  std::optional<std::array<float, 3>> dark_about(int x, int y, const SurfacePart& piece, float limit) const {
    std::vector<const float*> dark;
    around(x, y, surroundings, [&](int u, int v) {
      const auto other = piece_of(u, v, piece.vergence_D);
      if (other && brightness_of(other->rgb) <= limit) dark.push_back(other->rgb);
    });
    if (dark.empty()) return std::nullopt;
    const std::size_t half = (dark.size() + 1) / 2;
    std::stable_sort(dark.begin(), dark.end(),
                     [](const float* a, const float* b) { return brightness_of(a) < brightness_of(b); });
    std::array<double, 3> sum{};
    for (std::size_t i = 0; i < half; ++i)
      for (int c = 0; c < 3; ++c) sum[c] += dark[i][c];
    std::array<float, 3> mean;
    for (int c = 0; c < 3; ++c) mean[c] = static_cast<float>(sum[c] / static_cast<double>(half));
    return mean;
  }

  /// The picture's surfaces go on where their lamps were, for what surrounds them is sharpened by their colours.
  void guess_what_is_left() {
    std::vector<HiddenPixel> left;
    for (const Found& found : found_)
      if (!found.detail) left.push_back(found.left);
    guess_outshone(picture_, left);
    auto next = left.begin();
    for (const Found& found : found_)
      if (!found.detail) std::copy_n((next++)->rgb, 3, found.rgb);
  }

  /// The largest brightness about a piece on its surface, of what is neither a lamp nor beside one.
  float brightest_about(int x, int y, const SurfacePart& piece) const {
    float brightest = 0.0f;
    around(x, y, surroundings, [&](int u, int v) {
      const auto other = piece_of(u, v, piece.vergence_D);
      if (!other || brightness_of(other->rgb) <= brightest || brightness_of(other->rgb) > level_) return;
      if (!is_rim(u, v, *other)) brightest = brightness_of(other->rgb);
    });
    return brightest;
  }

  /// What a lamp beside it leaves in a pixel: the light that is no brighter than the level.
  bool is_rim(int x, int y, const SurfacePart& piece) const {
    bool beside = false;
    const float bright = std::max(level_, brighter * brightness_of(piece.rgb));
    around(x, y, 1, [&](int u, int v) {
      if (const auto other = piece_of(u, v, piece.vergence_D)) beside |= brightness_of(other->rgb) > bright;
    });
    return beside;
  }

  /// The places of a pixel that a lamp fills, by the share of its full brightness that it has, and where its neighbours
  /// are bright.
  std::uint16_t places_of(int x, int y, const SurfacePart& piece, bool hidden, float dark) const {
    float shares[3][3], most = brightness_of(piece.rgb);
    const auto brightness = [&](int dx, int dy) {
      if (!inside(x + dx, y + dy)) return brightness_of(piece.rgb);
      if (!hidden) return brightness_of(picture_.radiance.at(x + dx, y + dy));
      const auto other = piece_of(x + dx, y + dy, piece.vergence_D);
      return brightness_of(other ? other->rgb : piece.rgb);
    };
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) most = std::max(most, shares[dy + 1][dx + 1] = brightness(dx, dy));
    for (auto& row : shares)
      for (float& share : row) share = std::clamp((share - dark) / (most - dark), 0.0f, 1.0f);
    const float to_right = shares[0][2] + 2.0f * shares[1][2] + shares[2][2] - shares[0][0] - 2.0f * shares[1][0] -
                           shares[2][0],
                down = shares[2][0] + 2.0f * shares[2][1] + shares[2][2] - shares[0][0] - 2.0f * shares[0][1] -
                       shares[0][2];
    std::array<int, 16> places;
    std::iota(places.begin(), places.end(), 0);
    std::stable_sort(places.begin(), places.end(), [&](int a, int b) {
      return to_right * (a % 4) + down * (a / 4) > to_right * (b % 4) + down * (b / 4);
    });
    const int count =
        to_right == 0.0f && down == 0.0f ? 16 : std::max(1, static_cast<int>(16.0f * shares[1][1] + 0.5f));
    std::uint16_t filled = 0;
    for (int i = 0; i < count; ++i) filled |= static_cast<std::uint16_t>(1 << places[static_cast<std::size_t>(i)]);
    return filled;
  }

  /// A bright pixel, and the rim about it.
  void examine_about(int x, int y) {
    around(x, y, 1, [&](int u, int v) {
      const SurfacePart piece = front(u, v);
      if (seen_[index(u, v)] || !(brightness_of(piece.rgb) > level_ || is_rim(u, v, piece))) return;
      seen_[index(u, v)] = true;
      examine(u, v, piece, nullptr);
    });
  }

  void examine(int x, int y, const SurfacePart& piece, Detail* hidden) {
    const float brightness = brightness_of(piece.rgb);
    const bool bright = brightness > level_;
    const auto dark = dark_about(x, y, piece, bright ? std::min(brightness / brighter, level_) : brightness);
    constexpr float clearly = 2.0f;  // brighter than what lies about it: not its own texture
    if (!dark || brightness <= clearly * brightness_of(dark->data())) return;
    if (!bright && brightness <= brightest_about(x, y, piece)) return;
    LampPixel lamp{x, y, piece.vergence_D, {}, places_of(x, y, piece, hidden != nullptr, brightness_of(dark->data()))};
    if (!hidden && beside_an_edge(x, y)) give_to_its_surface(lamp);
    found_.push_back({piece.rgb,
                      hidden,
                      {piece.rgb[0], piece.rgb[1], piece.rgb[2]},
                      {x, y, piece.vergence_D, piece.coverage, {(*dark)[0], (*dark)[1], (*dark)[2]}},
                      lamp});
  }

  /// A pixel beside an edge may hold the light of a lamp beyond it: if the unmixed bright pixels about it are there.
  void give_to_its_surface(LampPixel& lamp) const {
    int own = 0, nearest = 9;
    int at_x = lamp.x, at_y = lamp.y;
    around(lamp.x, lamp.y, 2, [&](int u, int v) {
      if (brightness_of(picture_.radiance.at(u, v)) <= level_ || beside_an_edge(u, v)) return;
      if (same(picture_.vergence_D[index(u, v)], lamp.vergence_D)) {
        ++own;
      } else if (const int distance = std::abs(u - lamp.x) + std::abs(v - lamp.y); distance < nearest) {
        nearest = distance;
        at_x = u;
        at_y = v;
      }
    });
    if (own > 0 || nearest > 4) return;
    const double other_D = picture_.vergence_D[index(at_x, at_y)];
    if (other_D < lamp.vergence_D) step_out(lamp, at_x, at_y);
    lamp.vergence_D = other_D;
  }

  /// Light from behind comes past the edge of its pixel: it moves to the next pixel's side.
  static void step_out(LampPixel& lamp, int towards_x, int towards_y) {
    const int dx = std::clamp(towards_x - lamp.x, -1, 1), dy = std::clamp(towards_y - lamp.y, -1, 1);
    std::uint16_t places = 0;
    for (int place = 0; place < 16; ++place)
      if ((dx == 0 || place % 4 == (dx > 0 ? 0 : 3)) && (dy == 0 || place / 4 == (dy > 0 ? 0 : 3)))
        places |= static_cast<std::uint16_t>(1 << place);
    lamp.x += dx;
    lamp.y += dy;
    lamp.places = places;
  }

  LayeredPicture& picture_;
  int width_, height_;
  float level_;
  std::vector<bool> seen_;
  std::vector<Found> found_;
};

float level_of(const LayeredPicture& picture) {
  return bright_level(picture.radiance, brighter);
}

bool has_light_above(const LayeredPicture& picture, float level) {
  const auto bright = [&](float value) { return value > level; };
  return std::any_of(picture.radiance.pixels.begin(), picture.radiance.pixels.end(), bright) ||
         std::any_of(picture.hidden.begin(), picture.hidden.end(),
                     [&](const HiddenPixel& h) { return std::any_of(h.rgb, h.rgb + 3, bright); });
}

}  // namespace

bool may_have_lamps(const LayeredPicture& picture) {
  return has_light_above(picture, level_of(picture));
}

void take_lamps(LayeredPicture& picture) {
  const float level = level_of(picture);
  if (!has_light_above(picture, level)) return;
  LampSearch search(picture, level);
  search.search();
  search.take();
}

}  // namespace sturm
