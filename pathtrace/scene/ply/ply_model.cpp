#include "pathtrace/scene/ply/ply_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "io/files/error.h"
#include "io/files/text_file.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/obj/polygon_triangles.h"
#include "pathtrace/scene/ply/ply_bytes.h"
#include "pathtrace/scene/ply/ply_header.h"
#include "pathtrace/scene/ply/ply_text.h"

namespace sturm {
namespace {

/// What numbers of a vertex mean.
enum Role : std::size_t { x, y, z, nx, ny, nz, u, v, red, green, blue, alpha, other, roles };

Role role_of(std::string_view name) {
  constexpr std::pair<std::string_view, Role> names[] = {{"x", x},
                                                         {"y", y},
                                                         {"z", z},
                                                         {"nx", nx},
                                                         {"ny", ny},
                                                         {"nz", nz},
                                                         {"u", u},
                                                         {"s", u},
                                                         {"texture_u", u},
                                                         {"v", v},
                                                         {"t", v},
                                                         {"texture_v", v},
                                                         {"red", red},
                                                         {"r", red},
                                                         {"green", green},
                                                         {"g", green},
                                                         {"blue", blue},
                                                         {"b", blue},
                                                         {"alpha", alpha},
                                                         {"diffuse_red", red},
                                                         {"diffuse_green", green},
                                                         {"diffuse_blue", blue}};
  for (const auto& [known, role] : names)
    if (known == name) return role;
  return other;
}

bool names_corners(const PlyProperty& property) {
  return property.count && (property.name == "vertex_indices" || property.name == "vertex_index" ||
                            property.name == "vertex_indexes" || property.name == "vert_index");
}

double white_of(PlyType type) {
  return type == PlyType::uint16 ? 65535.0 : is_whole(type) ? 255.0 : 1.0;
}

template <class Values>
class ElementReader {
 public:
  ElementReader(const PlyHeader& header, const std::string& file, Values values)
      : header_(header), file_(file), values_(std::move(values)) {
    for (const PlyElement& element : header.elements)
      if (element.name == "vertex") vertex_count_ = element.count;
    if (vertex_count_ > std::numeric_limits<std::uint32_t>::max())
      throw InputError(file_, "element \"vertex\"", std::to_string(vertex_count_), "fewer than 2^32 vertices");
  }

  PlyModel run() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty() && element.name != "vertex") continue;  // however many of them: nothing is stored
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "tristrips")
        read_strips(element);
      else
        pass_over(element);
    }
    cut_faces();
    if (coordinates_missing_)
      model_.left_out.push_back("texture coordinates of faces, which " + std::to_string(coordinates_missing_) +
                                " of them lack,");
    if (has_transparency_) model_.left_out.push_back("alpha of vertex colours");
    model_.textures = header_.textures;
    return std::move(model_);
  }

 private:
  [[noreturn]] void fail(const std::string& value, const std::string& expected) const {
    throw InputError(values_.place(), "", value, expected);
  }

  std::size_t list_length(const PlyProperty& property) {
    const double length = values_.number(*property.count);
    if (!(length >= 0.0 && length == std::floor(length) && length <= static_cast<double>(values_.room(property.type))))
      fail("a list of " + exact_number(length) + " numbers", "a length that the file has room for");
    return static_cast<std::size_t>(length);
  }

  void skip(const PlyProperty& property) { values_.skip(property.type, property.count ? list_length(property) : 1); }

  void pass_over(const PlyElement& element) {
    if (element.count > 0 && (element.name == "edge" || element.name == "material"))
      model_.left_out.push_back(std::to_string(element.count) + " elements " + in_quotes(element.name));
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin();
      for (const PlyProperty& property : element.properties) skip(property);
      values_.end();
    }
  }

  void read_vertices(const PlyElement& element) {
    std::array<bool, roles> has{};
    std::vector<Role> role;
    std::array<double, roles> white;
    white.fill(1.0);
    for (const PlyProperty& property : element.properties) {
      role.push_back(property.count ? other : role_of(property.name));
      has[role.back()] = true;
      if (role.back() <= z && header_.encoding != PlyHeader::Encoding::text)
        model_.rounded = model_.rounded || property.type == PlyType::float32;
      if (role.back() >= red) white[role.back()] = white_of(property.type);
    }
    if (!(has[x] && has[y] && has[z])) throw InputError(file_, "element \"vertex\"", "", "the properties x, y and z");
    const bool has_normals = has[nx] && has[ny] && has[nz], has_texture = has[u] && has[v],
               has_colours = has[red] && has[green] && has[blue];
    model_.positions.reserve(element.count);
    if (has_normals) model_.normals.reserve(element.count);
    if (has_texture) model_.texture_coordinates.reserve(element.count);
    if (has_colours) model_.colours.reserve(element.count);
    std::array<double, roles> number{};
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin();
      for (std::size_t k = 0; k < role.size(); ++k)
        if (element.properties[k].count)
          skip(element.properties[k]);
        else
          number[role[k]] = values_.number(element.properties[k].type);
      values_.end();
      add_position({number[x], number[y], number[z]});
      if (has_normals) add_normal({number[nx], number[ny], number[nz]});
      if (has_texture) model_.texture_coordinates.push_back(coordinate(number[u], number[v]));
      if (!has_colours) continue;
      model_.colours.push_back(
          Eigen::Vector3d(number[red] / white[red], number[green] / white[green], number[blue] / white[blue])
              .cast<float>());
      has_transparency_ = has_transparency_ || (has[alpha] && number[alpha] < white[alpha]);
    }
  }

  void add_position(const Eigen::Vector3d& position) {
    if (!position.allFinite())
      fail("(" + exact_number(position.x()) + ", " + exact_number(position.y()) + ", " + exact_number(position.z()) +
               ")",
           "finite positions");
    model_.positions.push_back(position);
  }

  /// Programs write nan for the normals of triangles without area; such a normal says nothing.
  void add_normal(const Eigen::Vector3d& normal) {
    model_.normals.push_back(normal.allFinite() ? normal.cast<float>() : Eigen::Vector3f(Eigen::Vector3f::Zero()));
  }

  Eigen::Vector2f coordinate(double along, double up) const {
    const Eigen::Vector2f both(static_cast<float>(along), static_cast<float>(up));
    if (!both.allFinite())
      fail("(" + exact_number(along) + ", " + exact_number(up) + ")", "finite texture coordinates");
    return both;
  }

  std::uint32_t vertex(PlyType type, double number) const {
    if (!(is_whole(type) && number >= 0.0 && number < static_cast<double>(vertex_count_) &&
          number == std::floor(number)))
      fail(exact_number(number), vertex_count_ ? "numbers of vertices, from 0 to " + std::to_string(vertex_count_ - 1)
                                               : std::string("a file with vertices"));
    return static_cast<std::uint32_t>(number);
  }

  void read_faces(const PlyElement& element) {
    face_sizes_.reserve(element.count);
    const bool has_coordinates = std::any_of(element.properties.begin(), element.properties.end(),
                                             [](const auto& p) { return p.count && p.name == "texcoord"; });
    if (std::any_of(element.properties.begin(), element.properties.end(),
                    [](const auto& p) { return !p.count && role_of(p.name) >= red && role_of(p.name) <= blue; }))
      model_.left_out.push_back("colours of faces");
    const Eigen::Vector2f nowhere(0.0f, 0.0f);
    if (has_coordinates) corner_coordinates_.resize(corners_.size(), nowhere);  // of strips before the faces
    std::vector<Eigen::Vector2f> coordinates;
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin();
      coordinates.clear();
      const std::size_t first = corners_.size();
      for (const PlyProperty& property : element.properties)
        if (names_corners(property))
          read_corners(property);
        else if (property.count && property.name == "texcoord")
          read_coordinates(property, coordinates);
        else
          skip(property);
      values_.end();
      face_sizes_.push_back(static_cast<std::uint32_t>(corners_.size() - first));
      if (!has_coordinates) continue;
      if (coordinates.size() != corners_.size() - first) {
        ++coordinates_missing_;
        coordinates.assign(corners_.size() - first, nowhere);
      }
      corner_coordinates_.insert(corner_coordinates_.end(), coordinates.begin(), coordinates.end());
    }
  }

  void read_corners(const PlyProperty& property) {
    const std::size_t length = list_length(property);
    for (std::size_t k = 0; k < length; ++k) corners_.push_back(vertex(property.type, values_.number(property.type)));
  }

  void read_coordinates(const PlyProperty& property, std::vector<Eigen::Vector2f>& coordinates) {
    const std::size_t length = list_length(property);
    for (std::size_t k = 0; k + 1 < length; k += 2) {
      const double along = values_.number(property.type), up = values_.number(property.type);
      coordinates.push_back(coordinate(along, up));
    }
    values_.skip(property.type, length % 2);
  }

  /// Every second triangle of a strip is wound the other way.
  void read_strips(const PlyElement& element) {
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.begin();
      for (const PlyProperty& property : element.properties)
        if (names_corners(property))
          read_strip(property);
        else
          skip(property);
      values_.end();
    }
  }

  void read_strip(const PlyProperty& property) {
    const std::size_t length = list_length(property);
    std::array<std::uint32_t, 2> before{};
    std::size_t in_strip = 0;
    for (std::size_t k = 0; k < length; ++k) {
      const double number = values_.number(property.type);
      if (number == -1.0) {
        in_strip = 0;
        continue;
      }
      const std::uint32_t corner = vertex(property.type, number);
      if (in_strip >= 2 && in_strip % 2 == 0) add_face({before[0], before[1], corner});
      if (in_strip >= 2 && in_strip % 2 == 1) add_face({before[1], before[0], corner});
      before = {before[1], corner};
      ++in_strip;
    }
  }

  void add_face(const std::array<std::uint32_t, 3>& corners) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    face_sizes_.push_back(3);
  }

  /// Faces may stand before the vertices, so they are cut when all is read.
  void cut_faces() {
    model_.triangles.reserve(face_sizes_.size());
    const bool has_coordinates = !corner_coordinates_.empty();
    if (has_coordinates) corner_coordinates_.resize(corners_.size(), Eigen::Vector2f(0.0f, 0.0f));  // of strips behind
    std::vector<Eigen::Vector3d> outline;
    std::vector<std::array<std::uint32_t, 3>> cut;
    std::size_t first = 0;
    for (const std::uint32_t size : face_sizes_) {
      cut.clear();
      if (size == 3) cut.push_back({0, 1, 2});
      if (size > 3) {
        outline.clear();
        for (std::size_t k = first; k < first + size; ++k) outline.push_back(model_.positions[corners_[k]]);
        add_triangles_of(outline, cut);
      }
      for (const auto& [a, b, c] : cut) {
        model_.triangles.push_back({corners_[first + a], corners_[first + b], corners_[first + c]});
        if (has_coordinates)
          model_.corner_coordinates.push_back(
              {corner_coordinates_[first + a], corner_coordinates_[first + b], corner_coordinates_[first + c]});
      }
      first += size;
    }
  }

  const PlyHeader& header_;
  const std::string& file_;
  Values values_;
  PlyModel model_;
  std::size_t vertex_count_ = 0, coordinates_missing_ = 0;
  bool has_transparency_ = false;
  std::vector<std::uint32_t> corners_;               // of all faces
  std::vector<Eigen::Vector2f> corner_coordinates_;  // one for each of them, or empty
  std::vector<std::uint32_t> face_sizes_;            // corners of each face
};

}  // namespace

PlyModel read_ply(const std::filesystem::path& file) {
  const std::optional<std::string> contents = file_contents(file);
  if (!contents) throw InputError(file.string(), "", "", "a file that can be read");
  const PlyHeader header = read_ply_header(file, *contents);
  const std::string_view rest = std::string_view(*contents).substr(header.bytes);
  const std::string name = file.string();
  if (header.encoding == PlyHeader::Encoding::text)
    return ElementReader(header, name, PlyText(name, rest, header.lines)).run();
  if (header.encoding == PlyHeader::Encoding::little_endian)
    return ElementReader(header, name, PlyBytes<std::endian::little>(name, rest, header.bytes)).run();
  return ElementReader(header, name, PlyBytes<std::endian::big>(name, rest, header.bytes)).run();
}

}  // namespace sturm
