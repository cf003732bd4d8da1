#include "io/images/icc_profile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>

#include "io/images/big_endian.h"
#include "io/images/tone_map.h"

namespace sturm {

namespace {

double fixed_point(std::string_view bytes, std::size_t at) {
  return static_cast<std::int32_t>(big_endian(bytes, at, 4)) / 65536.0;
}

/// The bytes of a tag; empty where it is not there or breaks off.
std::string_view tag(std::string_view profile, std::string_view name) {
  constexpr std::size_t header = 128, entry = 12;
  if (profile.size() < header + 4) return {};
  const std::uint64_t stated = big_endian(profile, header, 4);
  const std::uint64_t count = std::min<std::uint64_t>(stated, (profile.size() - header - 4) / entry);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t at = header + 4 + entry * i;
    if (profile.substr(at, 4) != name) continue;
    const std::uint64_t start = big_endian(profile, at + 4, 4), size = big_endian(profile, at + 8, 4);
    return start <= profile.size() && size <= profile.size() - start ? profile.substr(start, size) : "";
  }
  return {};
}

std::string description(std::string_view profile) {
  const std::string_view text = tag(profile, "desc");
  if (text.starts_with("desc") && text.size() > 12) {
    const std::string_view name = text.substr(12, big_endian(text, 8, 4));
    return std::string(name.substr(0, name.find('\0')));
  }
  if (!text.starts_with("mluc") || text.size() < 28) return "";
  std::string name;  // UTF-16, of which names have letters of ASCII
  const std::uint64_t size = big_endian(text, 20, 4), start = big_endian(text, 24, 4);
  for (std::uint64_t i = start; i + 1 < std::min<std::uint64_t>(start + size, text.size()); i += 2)
    name += text[i] == 0 ? text[i + 1] : '?';
  return name;
}

/// The light of a number from 0 to 1 by a curve of a profile.
std::optional<double> light_by_parameters(std::string_view curve, double x) {
  constexpr std::array<std::size_t, 5> counts = {1, 3, 4, 5, 7};
  const std::uint64_t kind = big_endian(curve, 8, 2);
  if (kind >= counts.size() || curve.size() < 12 + 4 * counts[kind]) return std::nullopt;
  std::array<double, 7> p{};  // g a b c d e f
  for (std::size_t i = 0; i < counts[kind]; ++i) p[i] = fixed_point(curve, 12 + 4 * i);
  const auto [g, a, b, c, d, e, f] = p;
  switch (kind) {
    case 0:
      return std::pow(x, g);
    case 1:
      return a * x + b >= 0.0 ? std::pow(a * x + b, g) : 0.0;
    case 2:
      return a * x + b >= 0.0 ? std::pow(a * x + b, g) + c : c;
    case 3:
      return x >= d ? std::pow(a * x + b, g) : c * x;
    default:
      return x >= d ? std::pow(a * x + b, g) + e : c * x + f;
  }
}

std::optional<double> light_of(std::string_view curve, double x) {
  if (curve.size() < 12) return std::nullopt;
  if (curve.starts_with("para")) return light_by_parameters(curve, x);
  if (!curve.starts_with("curv")) return std::nullopt;
  const std::uint64_t count = big_endian(curve, 8, 4);
  if (count == 0) return x;
  if (count > (curve.size() - 12) / 2) return std::nullopt;
  const auto entry = [&](std::uint64_t i) { return static_cast<double>(big_endian(curve, 12 + 2 * i, 2)); };
  if (count == 1) return std::pow(x, entry(0) / 256.0);
  const double at = x * static_cast<double>(count - 1);
  const auto below = std::min(static_cast<std::uint64_t>(at), count - 2);
  const double share = at - static_cast<double>(below);
  return ((1.0 - share) * entry(below) + share * entry(below + 1)) / 65535.0;
}

bool follows(std::string_view curve, const std::function<double(double)>& wanted) {
  constexpr double table_rounding = 2e-3;  // tables of few entries, and gamma 2.2 is further away
  for (const double x : {0.1, 0.25, 0.5, 0.75})
    if (const auto light = light_of(curve, x); !light || !(std::abs(*light - wanted(x)) <= table_rounding))
      return false;
  return true;
}

IccCurve curve_of(std::string_view profile, std::initializer_list<const char*> names) {
  const auto all_follow = [&](const std::function<double(double)>& wanted) {
    return std::all_of(names.begin(), names.end(),
                       [&](const char* name) { return follows(tag(profile, name), wanted); });
  };
  if (all_follow([](double x) { return static_cast<double>(srgb_to_linear(static_cast<float>(x))); }))
    return IccCurve::Srgb;
  return all_follow([](double x) { return x; }) ? IccCurve::Linear : IccCurve::Other;
}

/// Whether the colours of red, green and blue under D50 are sRGB's [IEC 61966-2-1, adapted by Bradford's transform].
bool has_srgb_colorants(std::string_view profile) {
  constexpr double colorant_rounding = 3e-3;
  struct Colorant {
    const char* name;
    std::array<double, 3> xyz;
  };
  constexpr std::array<Colorant, 3> srgb = {Colorant{"rXYZ", {0.4361, 0.2225, 0.0139}},
                                            Colorant{"gXYZ", {0.3851, 0.7169, 0.0971}},
                                            Colorant{"bXYZ", {0.1431, 0.0606, 0.7141}}};
  for (const Colorant& colorant : srgb) {
    const std::string_view stated = tag(profile, colorant.name);
    if (!stated.starts_with("XYZ ") || stated.size() < 20) return false;
    for (std::size_t i = 0; i < 3; ++i)
      if (std::abs(fixed_point(stated, 8 + 4 * i) - colorant.xyz[i]) > colorant_rounding) return false;
  }
  return true;
}

}  // namespace

IccProfile read_icc_profile(std::span<const unsigned char> bytes) {
  const std::string_view profile(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  IccProfile read;
  read.name = description(profile);
  const std::string_view space = profile.size() >= 20 ? profile.substr(16, 4) : "";
  if (space == "GRAY") {
    read.has_rec709_primaries = true;
    read.curve = curve_of(profile, {"kTRC"});
  } else if (space == "RGB ") {
    read.has_rec709_primaries = has_srgb_colorants(profile);
    read.curve = curve_of(profile, {"rTRC", "gTRC", "bTRC"});
  }
  return read;
}

}  // namespace sturm
