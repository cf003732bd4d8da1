#include "io/images/stated_colours.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/files/readable_text.h"
#include "io/images/big_endian.h"
#include "io/images/changed_colours.h"
#include "io/images/colour_primaries.h"
#include "io/images/icc_profile.h"
#include "io/images/tone_map.h"

namespace sturm {

namespace {

using namespace std::string_view_literals;

constexpr double png_unit = 100000.0;  // chunks count in hundred thousandths
constexpr double srgb_gamma = 2.2, gamma_rounding = 0.02;

/// The chunks before the pixels that speak of colours; empty where they are not there.
struct ColourChunks {
  std::string cicp, srgb, gama, chrm;
  bool has_profile = false;
};

ColourChunks colour_chunks(const BytesAt& bytes_at) {
  constexpr std::size_t longest = 32;  // cHRM
  ColourChunks chunks;
  for (std::uint64_t at = 8;;) {
    const std::string chunk = bytes_at(at, 8 + longest);
    if (chunk.size() < 8) return chunks;
    const std::uint64_t length = big_endian(chunk, 0, 4);
    const std::string_view kind = std::string_view(chunk).substr(4, 4);
    if (kind == "IDAT" || kind == "IEND") return chunks;
    const std::string body = chunk.substr(8, static_cast<std::size_t>(std::min<std::uint64_t>(length, longest)));
    if (kind == "cICP" && body.size() == 4) chunks.cicp = body;
    if (kind == "sRGB") chunks.srgb = kind;
    if (kind == "gAMA" && body.size() == 4) chunks.gama = body;
    if (kind == "cHRM" && body.size() == 32) chunks.chrm = body;
    if (kind == "iCCP") chunks.has_profile = true;
    at += 12 + length;
  }
}

ColourPrimaries primaries_of_chunk(std::string_view chrm) {
  const auto xy = [&](std::size_t place) -> Eigen::Vector2d {
    return Eigen::Vector2d(static_cast<double>(big_endian(chrm, 8 * place, 4)),
                           static_cast<double>(big_endian(chrm, 8 * place + 4, 4))) /
           png_unit;
  };
  return {xy(1), xy(2), xy(3), xy(0)};
}

}  // namespace

StatedColours colours_of_png(const BytesAt& bytes_at) {
  const ColourChunks chunks = colour_chunks(bytes_at);
  StatedColours colours;
  if (!chunks.cicp.empty()) {
    if (chunks.cicp != "\x01\x0d\0\x01"sv)  // Rec. 709's primaries, sRGB's curve, RGB, full range
      colours.notes.push_back("its cICP (primaries " + std::to_string(big_endian(chunks.cicp, 0, 1)) + ", transfer " +
                              std::to_string(big_endian(chunks.cicp, 1, 1)) + ") is not followed");
    return colours;
  }
  if (chunks.has_profile || !chunks.srgb.empty()) return colours;
  if (const std::uint64_t stored = chunks.gama.empty() ? 0 : big_endian(chunks.gama, 0, 4); stored > 0) {
    const double gamma = png_unit / static_cast<double>(stored);
    if (std::abs(gamma / srgb_gamma - 1.0) > gamma_rounding) colours.gamma = gamma;
  }
  if (!chunks.chrm.empty())
    if (const ColourPrimaries primaries = primaries_of_chunk(chunks.chrm); !primaries.is_rec709())
      colours.notes.push_back("its primaries are not followed (cHRM): " + primaries.text());
  return colours;
}

std::optional<std::string> note_of_profile(std::span<const unsigned char> profile, bool of_integers) {
  const IccProfile read = read_icc_profile(profile);
  if (read.has_rec709_primaries && read.curve == (of_integers ? IccCurve::Srgb : IccCurve::Linear)) return std::nullopt;
  return "its colour profile " + (read.name.empty() ? "" : "\"" + readable(read.name) + "\" ") + "is not applied";
}

Image decoded_light(const Image& stored, const StatedColours& colours) {
  if (!colours.gamma) return srgb_to_linear(stored);
  const auto gamma = static_cast<float>(*colours.gamma);
  return changed_colours(stored, [gamma](float value) { return std::pow(value, gamma); });
}

}  // namespace sturm
