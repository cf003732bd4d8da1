#include "io/specs/lens_files/zemax_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "io/files/csv.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/readable_text.h"
#include "io/specs/sag_grid.h"
#include "lensmodel/units.h"

namespace sturm {

namespace {

using Words = std::vector<std::string>;

/// Nodes of a GRID_SAG: row by row from the top, each from −x to +x, counted from 1 (or from 0 by some writers).
struct Grid {
  int columns = 0, rows = 0;
  double dx = 0.0, dy = 0.0;      // [file's unit]
  std::map<int, double> heights;  // by the node's number [file's unit]
};

/// One SURF of a file; lengths in the file's unit.
struct ZemaxSurface {
  int number = 0, line = 0;
  std::string type = "STANDARD";
  double curvature = 0.0, conic = 0.0, semi_diameter = 0.0;
  std::optional<double> thickness;  // none: infinite
  Words glass;
  std::map<int, double> parameters;
  bool has_extra_data = false;
  std::optional<Grid> grid;

  bool has_parameters() const {
    return std::any_of(parameters.begin(), parameters.end(), [](const auto& p) { return p.second != 0.0; });
  }
};

struct ZemaxFile {
  double unit_m = metres_per_millimetre;
  int configurations = 1;
  std::vector<ZemaxSurface> surfaces;
};

struct NamedGlass {
  std::string_view name;  // in catalogues
  double refractive_index;
};

/// Index for the d line. Catalogues have these under several names, which differ in more than hyphens.
constexpr std::array<NamedGlass, 18> glasses{{
    {"CR39", 1.498},
    {"TRIVEX", 1.53},
    {"POLYCARB", 1.586},
    {"POLYCARBONATE", 1.586},
    {"PC", 1.586},
    {"MR8", 1.60},
    {"MR7", 1.67},
    {"MR10", 1.67},
    {"MR174", 1.74},
    {"CROWN", 1.523},
    {"B270", 1.5230},
    {"BK7", 1.5168},
    {"NBK7", 1.5168},
    {"HK9L", 1.5168},
    {"SBSL7", 1.5163},
    {"PMMA", 1.4918},
    {"ACRYLIC", 1.4918},
    {"SILICA", 1.4585},
}};

std::string letters_and_digits(std::string_view name) {
  std::string result;
  for (const char c : name) {
    if (c >= 'a' && c <= 'z') result += static_cast<char>(c - 'a' + 'A');
    if ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')) result += c;
  }
  return result;
}

Words words_of(std::string_view line) {
  Words words;
  while (!line.empty()) {
    const std::size_t start = std::min(line.find_first_not_of(" \t\r"), line.size());
    const std::size_t end = std::min(line.find_first_of(" \t\r", start), line.size());
    if (end > start) words.emplace_back(line.substr(start, end - start));
    line.remove_prefix(end);
  }
  return words;
}

/// Reads a file line by line.
class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file) {}

  ZemaxFile run(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
      ++line_;
      words_ = words_of(text.substr(0, end));
      if (!words_.empty()) record();
      const bool pair = text.substr(end).starts_with("\r\n");
      text.remove_prefix(std::min(text.size(), end + (pair ? 2 : 1)));
    }
    if (zemax_.surfaces.empty()) throw InputError(file_, "", "no SURF", "a Zemax file with its surfaces");
    return std::move(zemax_);
  }

 private:
  [[noreturn]] void fail(const std::string& got, const std::string& expected) const {
    throw InputError(file_, "line " + std::to_string(line_), got, expected);
  }

  double number(std::size_t index) const {
    if (index >= words_.size()) fail(words_[0] + " with " + std::to_string(words_.size() - 1) + " values", "more");
    const std::optional<double> value = csv_number(words_[index]);
    if (!value || std::isnan(*value)) fail("\"" + readable(words_[index], 40) + "\"", "a number in " + words_[0]);
    return *value;
  }

  double finite(std::size_t index) const {
    const double value = number(index);
    if (!std::isfinite(value)) fail(words_[index], "a finite number in " + words_[0]);
    return value;
  }

  int integer(std::size_t index) const {
    const double value = finite(index);
    if (value != std::floor(value) || std::abs(value) > 1e7) fail(words_[index], "a whole number in " + words_[0]);
    return static_cast<int>(value);
  }

  void record() {
    const std::string& key = words_[0];
    if (key == "MODE" && words_.size() > 1 && words_[1] != "SEQ")
      fail("MODE " + words_[1], "a sequential file, MODE SEQ");
    if (key == "UNIT" && words_.size() > 1) unit();
    if (key == "MNUM" && words_.size() > 1) zemax_.configurations = integer(1);
    if (key == "SURF") {
      if (zemax_.surfaces.size() >= 4096) fail("more than 4096 surfaces", "a spectacle lens");
      zemax_.surfaces.emplace_back().number = integer(1);
      zemax_.surfaces.back().line = line_;
    } else if (!zemax_.surfaces.empty()) {
      surface_record(zemax_.surfaces.back());
    }
  }

  void unit() {
    const std::map<std::string, double, std::less<>> units{
        {"MM", metres_per_millimetre}, {"CM", 1e-2}, {"IN", 0.0254}, {"INCH", 0.0254}, {"M", 1.0}, {"METER", 1.0}};
    const auto known = units.find(letters_and_digits(words_[1]));
    if (known == units.end()) fail("UNIT " + words_[1], "MM, CM, IN or METER");
    zemax_.unit_m = known->second;
  }

  void surface_record(ZemaxSurface& s) {
    const std::string& key = words_[0];
    if (key == "TYPE") s.type = words_.size() > 1 ? words_[1] : "";
    if (key == "CURV") s.curvature = finite(1);
    if (key == "CONI") s.conic = finite(1);
    if (key == "DIAM") s.semi_diameter = std::abs(number(1));
    if (key == "GLAS") s.glass.assign(words_.begin() + 1, words_.end());
    if (key == "PARM") s.parameters[integer(1)] = finite(2);
    if (key == "XDAT") s.has_extra_data |= finite(2) != 0.0;
    if (key == "DISZ") {
      const bool infinite = words_.size() > 1 && words_[1].starts_with("INF");
      s.thickness = infinite ? std::nullopt : std::optional(finite(1));
    }
    if (key == "GDAT") grid(s);
    if (key == "GARR" && s.grid) height(*s.grid);
  }

  void grid(ZemaxSurface& s) {
    s.grid = Grid{integer(1), integer(2), finite(3), finite(4), {}};
    if (s.grid->columns < 2 || s.grid->rows < 2 || s.grid->columns > 4096 || s.grid->rows > 4096 ||
        !(s.grid->dx > 0.0) || !(s.grid->dy > 0.0))
      fail("GDAT of " + words_[1] + " by " + words_[2] + " nodes", "2 to 4096 nodes each way with a distance above 0");
  }

  void height(Grid& grid) {
    const int node = integer(1);
    if (node < 0 || node > grid.columns * grid.rows)
      fail("GARR " + words_[1], "a node from 1 to " + std::to_string(grid.columns * grid.rows));
    grid.heights[node] = finite(2);
  }

  const std::string& file_;
  int line_ = 0;
  Words words_;
  ZemaxFile zemax_;
};

[[noreturn]] void fail(const std::string& file, const ZemaxSurface& surface, const std::string& got,
                       const std::string& expected) {
  throw InputError(file, "surface " + std::to_string(surface.number) + " (line " + std::to_string(surface.line) + ")",
                   got, expected);
}

/// The lens under construction.
struct ZemaxBuilder {
  const ZemaxFile& zemax;
  const LensFileRequest& request;
  LensFile result{};

  /// Throws for a parameter that is not 0 but for those from `from` to `to`.
  void require_zero(const ZemaxSurface& s, int from, int to, const char* expected) const {
    for (const auto& [index, value] : s.parameters)
      if (index >= from && index <= to && value != 0.0)
        fail(request.file, s, s.type + " with PARM " + std::to_string(index) + " other than 0", expected);
    if (s.has_extra_data) fail(request.file, s, s.type + " with XDAT other than 0", expected);
  }

  /// [1/m] of a curvature or of a radius of 0 for flat; as everywhere, not sharper than a radius of 1 mm.
  double checked(double curvature, const ZemaxSurface& s) const {
    if (!(std::abs(curvature) <= 1.0 / metres_per_millimetre))
      fail(request.file, s, "a radius of " + plain_number(1.0 / (curvature * metres_per_millimetre), 12) + " mm",
           "a radius of at least 1 mm either way");
    return curvature;
  }

  Surface surface(const ZemaxSurface& s, const char* side) {
    const double curvature = checked(s.curvature / zemax.unit_m, s);
    if (s.type == "STANDARD" || s.type == "EVENASPH") {
      if (s.type == "EVENASPH")
        require_zero(s, 1, 8, "an even asphere without higher terms, which is a conic (or its heights as GRID_SAG)");
      if (s.conic == 0.0 || curvature == 0.0) return SphereSurface{curvature};
      return ConicSurface{curvature, s.conic};
    }
    if (s.type == "TOROIDAL") {
      require_zero(s, 2, 16, "a toroidal surface of two circles, without polynomial terms");
      if (s.conic != 0.0) fail(request.file, s, "TOROIDAL with a conic constant", "a toroidal surface of two circles");
      const auto radius = s.parameters.find(1);  // of the rotation about an axis along y; 0 stands for none
      const double sweep =
          radius == s.parameters.end() || radius->second == 0.0 ? 0.0 : 1.0 / (radius->second * zemax.unit_m);
      return TorusSurface(checked(sweep, s), curvature, 180.0);
    }
    if (s.type == "GRID_SAG") return grid_surface(s, side);
    fail(request.file, s, "TYPE " + readable(s.type, 40),
         "STANDARD, EVENASPH without higher terms, TOROIDAL or GRID_SAG on either side of the glass");
  }

  Surface grid_surface(const ZemaxSurface& s, const char* side) {
    require_zero(s, 1, 16, "heights on a conic, without further terms and not decentred");
    if (!s.grid || s.grid->heights.size() != static_cast<std::size_t>(s.grid->columns * s.grid->rows))
      fail(request.file, s, "GRID_SAG with " + std::to_string(s.grid ? s.grid->heights.size() : 0) + " heights",
           "GDAT and a GARR for each of its nodes");
    const int first = s.grid->heights.begin()->first;
    const ConicSurface base{s.curvature / zemax.unit_m, s.conic};
    std::vector<Eigen::Vector3d> points;
    for (const auto& [node, height] : s.grid->heights) {
      const int row = (node - first) / s.grid->columns, column = (node - first) % s.grid->columns;
      const double x = zemax.unit_m * s.grid->dx * (column - 0.5 * (s.grid->columns - 1));
      const double y = zemax.unit_m * s.grid->dy * (0.5 * (s.grid->rows - 1) - row);
      const auto sag = base.sag(x, y);
      if (!sag) fail(request.file, s, "a grid that is wider than its conic", "a conic that reaches every node");
      points.emplace_back(x, y, sag->value + zemax.unit_m * height);
    }
    const SagGrid grid = sag_surface(points, std::nullopt, 0.5 * result.lens.diameter_m, request.file);
    result.fits.push_back({side, grid.surface.grid().spacing, grid.residual, std::nullopt});
    return grid.surface;
  }

  double refractive_index(const ZemaxSurface& s) {
    if (request.refractive_index) return *request.refractive_index;
    const std::string name = letters_and_digits(s.glass[0]);
    const bool model = name == "BLANK" || (s.glass.size() > 1 && s.glass[1] == "1");
    if (model) {
      const auto index = s.glass.size() > 3 ? csv_number(s.glass[3]) : std::nullopt;
      if (!index || !(*index >= 1.0 && *index <= 4.0))
        fail(request.file, s, "a model glass without an index from 1 to 4", "GLAS ___BLANK 1 0 INDEX ABBE …");
      return *index;
    }
    for (const NamedGlass& glass : glasses)
      if (glass.name == name) {
        result.notes.push_back(request.file + ": glass " + s.glass[0] + " is taken with an index of " +
                               plain_number(glass.refractive_index));
        return glass.refractive_index;
      }
    fail(request.file, s, "glass \"" + readable(s.glass[0], 40) + "\"",
         "a known glass (CR39, TRIVEX, POLYCARB, MR-8, MR-7, MR-174, CROWN, B270, BK7, PMMA, …), a model glass, or "
         "\"refractive_index\" beside \"file\"");
  }
};

/// The one surface behind which there is glass.
std::size_t front_of(const ZemaxFile& zemax, const std::string& file) {
  std::optional<std::size_t> front;
  for (std::size_t i = 0; i < zemax.surfaces.size(); ++i) {
    const ZemaxSurface& s = zemax.surfaces[i];
    if (s.glass.empty()) continue;
    if (s.glass[0] == "MIRROR") fail(file, s, "a mirror", "a lens");
    if (front)
      fail(file, s,
           "a second glass (the first is behind surface " + std::to_string(zemax.surfaces[*front].number) + ")",
           "the two surfaces of one lens, which has one glass");
    front = i;
  }
  if (!front) throw InputError(file, "", "no GLAS", "a lens: a surface with a glass behind it, and the next one");
  if (*front + 1 >= zemax.surfaces.size())
    fail(file, zemax.surfaces[*front], "glass behind the last surface", "a surface behind the glass");
  return *front;
}

}  // namespace

LensFile zemax_lens(std::string_view text, const LensFileRequest& request) {
  const ZemaxFile zemax = Reader(request.file).run(text);
  const std::size_t index = front_of(zemax, request.file);
  const ZemaxSurface &front = zemax.surfaces[index], &back = zemax.surfaces[index + 1];
  ZemaxBuilder builder{zemax, request};
  Spectacles& lens = builder.result.lens;
  const double smaller = std::min(front.semi_diameter > 0.0 ? front.semi_diameter : back.semi_diameter,
                                  back.semi_diameter > 0.0 ? back.semi_diameter : front.semi_diameter);
  if (request.diameter_m)
    lens.diameter_m = *request.diameter_m;
  else if (smaller > 0.0)
    lens.diameter_m = 2.0 * zemax.unit_m * smaller;
  else
    builder.result.notes.push_back(request.file + ": " + assumed_diameter("DIAM", lens.diameter_m));
  if (!(lens.diameter_m > 0.0 && lens.diameter_m <= 0.2))
    fail(request.file, front, "a diameter of " + plain_number(lens.diameter_m / metres_per_millimetre, 12) + " mm",
         "at most 200 mm, or \"diameter_mm\" beside \"file\"");
  if (request.center_thickness_m)
    lens.center_thickness_m = *request.center_thickness_m;
  else if (front.thickness && *front.thickness > 0.0 && zemax.unit_m * *front.thickness <= 0.05)
    lens.center_thickness_m = zemax.unit_m * *front.thickness;
  else
    fail(request.file, front, "a glass without a thickness (DISZ) above 0 and up to 50 mm",
         "the lens's thickness at its centre");
  lens.refractive_index = builder.refractive_index(front);
  if (zemax.configurations > 1)
    builder.result.notes.push_back(request.file + ": of its " + std::to_string(zemax.configurations) +
                                   " configurations the one counts that its surfaces have");
  for (std::size_t i = 0; i < index; ++i)
    if (const ZemaxSurface& s = zemax.surfaces[i]; s.type == "COORDBRK" && s.has_parameters())
      builder.result.notes.push_back(request.file + ": the coordinate break of surface " + std::to_string(s.number) +
                                     " does not count; \"mounting\" beside \"file\" tilts or decentres a lens");
  lens.front = builder.surface(front, "front");
  lens.back = builder.surface(back, "back");
  return std::move(builder.result);
}

}  // namespace sturm
