#include "io/specs/lens_files/lens_file.h"

#include <algorithm>
#include <array>

#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/lower_case.h"
#include "io/files/text_encoding.h"
#include "io/files/text_file.h"
#include "io/specs/lens_files/vca_file.h"
#include "io/specs/lens_files/zemax_file.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

constexpr std::size_t largest_bytes = std::size_t{64} << 20;
constexpr std::string_view zemax_suffix = ".zmx";
constexpr std::array<std::string_view, 6> vca_suffixes{".oma", ".vca", ".dcs", ".lds", ".lms", ".sdf"};

}  // namespace

bool is_lens_file(std::string_view name) {
  const std::string lower = lower_case(name);
  const auto ends = [&](std::string_view suffix) { return lower.ends_with(suffix); };
  return ends(zemax_suffix) || std::ranges::any_of(vca_suffixes, ends);
}

std::string assumed_diameter(const std::string& record, double diameter_m) {
  return "it has no " + record + "; the diameter is taken as " + plain_number(diameter_m / metres_per_millimetre) +
         " mm";
}

LensFile read_lens_file(const LensFileRequest& request) {
  std::optional<std::string> contents = file_contents(request.file);
  if (!contents) throw InputError(request.file, "", "", "a lens file that can be read");
  if (contents->size() > largest_bytes) throw InputError(request.file, "", "more than 64 MiB", "a smaller lens file");
  const std::string text = utf8_text(std::move(*contents));
  return lower_case(request.file).ends_with(zemax_suffix) ? zemax_lens(text, request) : vca_lens(text, request);
}

}  // namespace sturm
