#include "io/images/radiance_hdr.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "io/files/formatted_text.h"
#include "io/files/readable_text.h"

namespace sturm {

namespace {

constexpr std::size_t shortest_run_line = 8, longest_run_line = 32767;  // in the new run lengths
// Old run lengths: a pixel, and two more that stand for up to 65535 of it.
constexpr std::size_t shortest_line_bytes = 4, most_pixels_per_byte = 8192;

/// Numbers separated by blanks; nothing else may stand there.
std::vector<double> numbers(std::string_view text) {
  std::vector<double> result;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    if (text.empty()) return result;
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number)) throw std::runtime_error("no number: " + readable(text, 40));
    result.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  }
}

/// One of the two axes of the line of sizes, "-Y 512".
struct Axis {
  char name = 'Y';
  bool forward = false;  // numbers grow to the right, or upwards
  std::size_t length = 0;
};

/// What the text before the pixels says.
struct Header {
  Axis lines, pixels;  // a scan line is what runs along `pixels`
  std::array<double, 3> gain{1.0, 1.0, 1.0};
  std::optional<ColourPrimaries> primaries;
  std::vector<std::string> notes;
};

class Reader {
 public:
  Reader(std::string_view bytes, std::size_t max_pixels) : bytes_(bytes), max_pixels_(max_pixels) {}

  RadianceHdr run() {
    read_header();
    std::vector<Rgbe> stored;
    for (std::size_t i = 0; i < header_.lines.length; ++i) read_line(stored);
    return {upright(stored), header_.primaries, std::move(header_.notes)};
  }

 private:
  using Rgbe = std::array<unsigned char, 4>;

  /// The column or row, from the left or the top, of the n-th pixel along an axis.
  static std::size_t position(const Axis& axis, std::size_t n) {
    const bool counts_on = axis.name == 'X' ? axis.forward : !axis.forward;
    return counts_on ? n : axis.length - 1 - n;
  }

  /// The picture of pixels in the order of the file. Room for it is made when all of them are there.
  Image upright(const std::vector<Rgbe>& stored) const {
    std::array<std::array<double, 3>, 256>
        scales{};  // of one step of a mantissa, by exponent; none for 0, which is black
    for (std::size_t e = 1; e < 256; ++e)
      for (std::size_t c = 0; c < 3; ++c) scales[e][c] = std::ldexp(1.0, static_cast<int>(e) - 136) / header_.gain[c];
    const bool rows = header_.lines.name == 'Y';
    const Axis &across = rows ? header_.pixels : header_.lines, &down = rows ? header_.lines : header_.pixels;
    Image image(static_cast<int>(across.length), static_cast<int>(down.length), 3);
    auto colour = stored.begin();
    for (std::size_t i = 0; i < header_.lines.length; ++i)
      for (std::size_t k = 0; k < header_.pixels.length; ++k, ++colour) {
        float* pixel =
            image.at(static_cast<int>(position(across, rows ? k : i)), static_cast<int>(position(down, rows ? i : k)));
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = static_cast<float>((*colour)[c] * scales[(*colour)[3]][c]);
      }
    return image;
  }

  std::string_view text_line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) throw std::runtime_error("a header that breaks off");
    std::string_view line = bytes_.substr(at_, end - at_);
    if (line.ends_with('\r')) line.remove_suffix(1);
    at_ = end + 1;
    return line;
  }

  void read_header() {
    text_line();  // #?RADIANCE
    for (std::string_view line = text_line(); !line.empty(); line = text_line()) read_variable(line);
    read_sizes(text_line());
  }

  void read_variable(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) return;
    const std::string_view key = line.substr(0, equals), value = line.substr(equals + 1);
    if (key == "FORMAT") {
      if (value.find("32-bit_rle_rgbe") == std::string_view::npos)
        throw std::runtime_error("FORMAT=" + readable(value, 40) + ", not 32-bit_rle_rgbe");
    } else if (key == "EXPOSURE") {
      divide(line, numbers(value), 1);
    } else if (key == "COLORCORR") {
      divide(line, numbers(value), 3);
    } else if (key == "PRIMARIES") {
      const std::vector<double> n = numbers(value);
      if (n.size() != 8) throw std::runtime_error(readable(line, 120) + ", not eight numbers");
      header_.primaries = ColourPrimaries{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}, {n[6], n[7]}};
    }
  }

  /// Pixels have been multiplied by these factors, all of them where there are several.
  void divide(std::string_view line, const std::vector<double>& factors, std::size_t count) {
    bool positive = factors.size() == count, all_one = true;
    for (const double factor : factors) {
      positive = positive && factor > 0.0;
      all_one = all_one && factor == 1.0;
    }
    if (!positive)
      throw std::runtime_error(readable(line, 120) + ", not " + (count == 1 ? "a number" : "three numbers") +
                               " above 0");
    for (std::size_t c = 0; c < 3; ++c) header_.gain[c] *= factors[count == 1 ? 0 : c];
    if (!all_one) header_.notes.push_back("divided by its " + readable(line, 120));
  }

  /// Takes "-Y 512" off the beginning of a text.
  bool take_axis(std::string_view& text, Axis& axis) const {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (text.size() < 3 || (text[0] != '+' && text[0] != '-') || (text[1] != 'X' && text[1] != 'Y')) return false;
    axis.forward = text[0] == '+';
    axis.name = text[1];
    text.remove_prefix(2);
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), axis.length);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return error == std::errc() && axis.length >= 1 && axis.length <= max_pixels_;
  }

  void read_sizes(std::string_view line) {
    std::string_view rest = line;
    if (!take_axis(rest, header_.lines) || !take_axis(rest, header_.pixels) ||
        header_.lines.name == header_.pixels.name || rest.find_first_not_of(' ') != std::string_view::npos)
      throw std::runtime_error("\"" + readable(line, 60) + "\" in place of sizes like \"-Y 512 +X 1024\"");
    const std::size_t pixels = header_.lines.length * header_.pixels.length;
    if (pixels > max_pixels_ || header_.lines.length > bytes_.size() / shortest_line_bytes ||
        pixels > bytes_.size() * most_pixels_per_byte)
      throw std::runtime_error("a header that claims " + std::to_string(pixels) + " pixels in a file of " +
                               std::to_string(bytes_.size()) + " bytes");
  }

  const unsigned char* take(std::size_t count) {
    if (bytes_.size() - at_ < count) throw std::runtime_error("pixels that break off");
    const auto* taken = reinterpret_cast<const unsigned char*>(bytes_.data()) + at_;
    at_ += count;
    return taken;
  }

  /// Appends a scan line to those that came before.
  void read_line(std::vector<Rgbe>& stored) {
    const std::size_t length = header_.pixels.length;
    if (length >= shortest_run_line && length <= longest_run_line && bytes_.size() - at_ >= 4) {
      const auto* start = reinterpret_cast<const unsigned char*>(bytes_.data()) + at_;
      if (start[0] == 2 && start[1] == 2 && start[2] < 128) {
        if ((std::size_t{start[2]} << 8 | start[3]) != length)
          throw std::runtime_error("a scan line of another length");
        at_ += 4;
        stored.resize(stored.size() + length);
        for (std::size_t component = 0; component < 4; ++component) read_runs(stored, component);
        return;
      }
    }
    read_pixels(stored);
  }

  /// One component of the last scan line.
  void read_runs(std::vector<Rgbe>& stored, std::size_t component) {
    for (std::size_t k = stored.size() - header_.pixels.length; k < stored.size();) {
      const std::size_t code = *take(1), count = code > 128 ? code - 128 : code;
      if (count == 0 || count > stored.size() - k) throw std::runtime_error("a run beyond its scan line");
      const unsigned char* values = take(code > 128 ? 1 : count);
      for (std::size_t i = 0; i < count; ++i) stored[k++][component] = values[code > 128 ? 0 : i];
    }
  }

  /// Flat pixels; (1, 1, 1, n) repeats the last one n times, 256 n times if it follows another one of its kind.
  void read_pixels(std::vector<Rgbe>& stored) {
    const std::size_t start = stored.size(), end = start + header_.pixels.length;
    std::size_t shift = 0;
    while (stored.size() < end) {
      const unsigned char* p = take(4);
      if (p[0] != 1 || p[1] != 1 || p[2] != 1) {
        stored.push_back({p[0], p[1], p[2], p[3]});
        shift = 0;
        continue;
      }
      const std::size_t count = shift < 32 ? std::size_t{p[3]} << shift : end;
      if (stored.size() == start || count > end - stored.size()) throw std::runtime_error("a run beyond its scan line");
      stored.insert(stored.end(), count, Rgbe(stored.back()));
      shift += 8;
    }
  }

  std::string_view bytes_;
  std::size_t max_pixels_, at_ = 0;
  Header header_;
};

}  // namespace

bool is_radiance_hdr(std::string_view bytes) {
  return bytes.starts_with("#?");
}

RadianceHdr decode_radiance_hdr(std::string_view bytes, std::size_t max_pixels) {
  return Reader(bytes, max_pixels).run();
}

}  // namespace sturm
