#include "pathtrace/scene/obj/obj_model.h"

#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>

#include "io/files/error.h"
#include "pathtrace/scene/message_text.h"
#include "pathtrace/scene/obj/obj_lines.h"
#include "pathtrace/scene/obj/obj_words.h"
#include "pathtrace/scene/obj/polygon_triangles.h"

namespace sturm {
namespace {

using Corner = ObjModel::Corner;

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& file) : lines_(file) {}

  ObjModel run() {
    while (lines_.next()) read_statement(lines_.text());
    check_numbers_ahead();
    finish_polygons();
    note(lines_left_out_, "lines");
    note(points_left_out_, "points");
    if (has_free_forms_) model_.left_out.push_back("free-form curves and surfaces");
    return std::move(model_);
  }

 private:
  /// Numbers of a line; more than most mean as many as there are.
  struct Numbers {
    static constexpr std::size_t most = 7;
    std::array<double, most> value;
    std::size_t count = 0;
  };
  /// A polygon with corners that the file names before it states them.
  struct LatePolygon {
    std::size_t part, first_triangle;
    std::vector<Corner> corners;
  };
  /// The largest number that was ahead of its list when it was read.
  struct NumberAhead {
    long long number = 0;
    long line = 0;
  };
  struct Weight {
    double value;
    long line;
  };

  [[noreturn]] void fail(std::string_view statement, const std::string& value, const std::string& expected) const {
    throw InputError(lines_.place(), std::string(statement), value, expected);
  }

  void note(std::size_t count, const char* what) {
    if (count) model_.left_out.push_back(std::to_string(count) + " " + what);
  }

  void read_statement(std::string_view line) {
    const std::string_view word = take_word(line);
    const char first = static_cast<char>(word[0] | 0x20);  // in lower case
    if (word.size() == 1) {
      if (first == 'v') return read_position(line);
      if (first == 'f') return read_face(word, line);
      if (first == 'o') return begin_object(line);
      if (first == 'g') return begin_groups(line);
      lines_left_out_ += first == 'l';
      points_left_out_ += first == 'p';
      return;
    }
    if (word.size() == 2 && first == 'v') {
      if (const char second = static_cast<char>(word[1] | 0x20); second == 't')
        return read_texture_coordinate(line);
      else if (second == 'n')
        return read_normal(line);
    }
    read_rare_statement(lower_case(word), line);
  }

  void read_rare_statement(const std::string& word, std::string_view line) {
    if (word == "fo") return read_face(word, line);  // faces of files before version 2.11
    if (word == "usemtl") return begin_material(trimmed(line));
    if (word == "mtllib" && !trimmed(line).empty())
      model_.libraries.push_back({std::string(trimmed(line)), lines_.number()});
    if (word == "curv" || word == "curv2" || word == "surf") has_free_forms_ = true;
  }

  Numbers numbers(std::string_view statement, std::string_view line) const {
    Numbers found;
    for (std::string_view word = take_word(line); !word.empty() && word[0] != '#'; word = take_word(line)) {
      const std::optional<double> number = number_of(word);
      if (!number) fail(statement, in_quotes(word), "numbers with a decimal point");
      if (found.count < Numbers::most) found.value[found.count] = *number;
      ++found.count;
    }
    return found;
  }

  void require_finite(std::string_view statement, const Numbers& found, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i)
      if (!std::isfinite(found.value[i]))
        fail(statement, exact_number(found.value[i]) + ", which is not finite", "finite numbers");
  }

  void read_position(std::string_view line) {
    const Numbers found = numbers("v", line);
    if (found.count < 3 || found.count == 5 || found.count > 7)
      fail("v", std::to_string(found.count) + " numbers", "x y z, x y z w, x y z r g b or x y z r g b a");
    require_finite("v", found, found.count);
    if (found.count == 4 && found.value[3] != 1.0)
      weights_[static_cast<std::uint32_t>(model_.positions.size())] = {found.value[3], lines_.number()};
    model_.positions.emplace_back(found.value[0], found.value[1], found.value[2]);
    if (found.count >= 6) {
      model_.colours.resize(model_.positions.size(), Eigen::Vector3f::Ones());
      for (int k = 0; k < 3; ++k)
        model_.colours.back()[k] = static_cast<float>(found.value[3 + static_cast<std::size_t>(k)]);
    }
  }

  void read_texture_coordinate(std::string_view line) {
    const Numbers found = numbers("vt", line);
    if (found.count == 0) fail("vt", "no numbers", "one to three numbers");
    require_finite("vt", found, std::min<std::size_t>(found.count, 2));
    model_.texture_coordinates.emplace_back(static_cast<float>(found.value[0]),
                                            found.count > 1 ? static_cast<float>(found.value[1]) : 0.0f);
  }

  /// Programs write nan for the normals of triangles without area; such a normal says nothing.
  void read_normal(std::string_view line) {
    const Numbers found = numbers("vn", line);
    if (found.count < 3) fail("vn", std::to_string(found.count) + " numbers", "three numbers");
    const Eigen::Vector3d normal(found.value[0], found.value[1], found.value[2]);
    model_.normals.push_back(normal.allFinite() ? normal.cast<float>() : Eigen::Vector3f(Eigen::Vector3f::Zero()));
  }

  void begin_object(std::string_view line) {
    object_ = without_comment(line);
    groups_.clear();
    forget_parts();
  }

  void begin_groups(std::string_view line) {
    groups_ = without_comment(line);
    forget_parts();
  }

  void begin_material(std::string_view name) {
    forget_parts();
    material_ = -1;
    if (name.empty()) return;
    const auto [at, is_new] = material_numbers_.try_emplace(std::string(name), model_.used_materials.size());
    if (is_new) model_.used_materials.push_back({std::string(name), lines_.number()});
    material_ = static_cast<int>(at->second);
  }

  void forget_parts() { current_.fill(unknown_part); }

  ObjModel::Part& part_of(bool has_texture, bool has_normals) {
    std::size_t& known = current_[(has_texture ? 1u : 0u) + (has_normals ? 2u : 0u)];
    if (known == unknown_part) {
      const auto [at, is_new] =
          part_numbers_.try_emplace({object_, groups_, material_, has_texture, has_normals}, model_.parts.size());
      if (is_new) model_.parts.push_back({object_, groups_, material_, has_texture, has_normals, {}});
      known = at->second;
    }
    return model_.parts[known];
  }

  /// The number of an element of a list, from 0, from the file's, which counts from 1, or from −1 backwards.
  std::uint32_t element(std::string_view statement, std::string_view& text, std::size_t count,
                        NumberAhead& ahead) const {
    if (text.starts_with('+')) text.remove_prefix(1);
    long long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto there = static_cast<long long>(count);
    if (error != std::errc() || number == 0 || number < -there || number >= ObjModel::none)
      fail(statement, in_quotes(text),
           "numbers of elements, from 1 on, or from -1 to -" + std::to_string(there) + " backwards");
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (number > there && number > ahead.number) ahead = {number, lines_.number()};
    return static_cast<std::uint32_t>(number < 0 ? there + number : number - 1);
  }

  /// v, v/vt, v//vn or v/vt/vn.
  Corner read_corner(std::string_view statement, std::string_view word) {
    Corner corner;
    std::string_view text = word;
    corner.position = element(statement, text, model_.positions.size(), ahead_[0]);
    const auto takes_slash = [&] {
      if (!text.starts_with('/')) return false;
      text.remove_prefix(1);
      return true;
    };
    if (takes_slash()) {
      if (!text.empty() && text[0] != '/')
        corner.texture = element(statement, text, model_.texture_coordinates.size(), ahead_[1]);
      if (takes_slash() && !text.empty()) corner.normal = element(statement, text, model_.normals.size(), ahead_[2]);
    }
    if (!text.empty()) fail(statement, in_quotes(word), "corners like 1, 1/2, 1//3 or 1/2/3");
    if (!weights_.empty()) require_weight_one(corner.position);
    return corner;
  }

  void require_weight_one(std::uint32_t position) const {
    if (const auto at = weights_.find(position); at != weights_.end())
      throw InputError(lines_.place(at->second.line), "v", "a weight of " + exact_number(at->second.value),
                       "a weight of 1 at the corners of faces");
  }

  void read_face(std::string_view statement, std::string_view line) {
    corners_.clear();
    for (std::string_view word = take_word(line); !word.empty() && word[0] != '#'; word = take_word(line))
      corners_.push_back(read_corner(statement, word));
    if (corners_.size() < 3) return;
    bool has_texture = true, has_normals = true, is_late = false;
    for (const Corner& corner : corners_) {
      has_texture = has_texture && corner.texture != ObjModel::none;
      has_normals = has_normals && corner.normal != ObjModel::none;
      is_late = is_late || corner.position >= model_.positions.size();
    }
    ObjModel::Part& part = part_of(has_texture, has_normals);
    if (corners_.size() == 3) return part.triangles.push_back({corners_[0], corners_[1], corners_[2]});
    if (is_late)
      late_.push_back({static_cast<std::size_t>(&part - model_.parts.data()), part.triangles.size(), corners_});
    for (const auto& [a, b, c] : triangles_of(corners_, is_late))
      part.triangles.push_back({corners_[a], corners_[b], corners_[c]});
  }

  /// Whatever its corners are, a polygon of n corners becomes n − 2 triangles; those of a late one keep the place.
  const std::vector<std::array<std::uint32_t, 3>>& triangles_of(const std::vector<Corner>& corners, bool is_late) {
    outline_.clear();
    for (const Corner& corner : corners)
      outline_.push_back(is_late ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : model_.positions[corner.position]);
    cut_.clear();
    add_triangles_of(outline_, cut_);
    return cut_;
  }

  void finish_polygons() {
    for (const LatePolygon& polygon : late_) {
      std::size_t place = polygon.first_triangle;
      for (const auto& [a, b, c] : triangles_of(polygon.corners, false))
        model_.parts[polygon.part].triangles[place++] = {polygon.corners[a], polygon.corners[b], polygon.corners[c]};
    }
    if (!model_.colours.empty()) model_.colours.resize(model_.positions.size(), Eigen::Vector3f::Ones());
  }

  void check_numbers_ahead() const {
    const std::array<std::pair<std::size_t, const char*>, 3> lists{
        {{model_.positions.size(), "v"}, {model_.texture_coordinates.size(), "vt"}, {model_.normals.size(), "vn"}}};
    for (std::size_t k = 0; k < lists.size(); ++k)
      if (ahead_[k].number > static_cast<long long>(lists[k].first))
        throw InputError(
            lines_.place(ahead_[k].line), "f", std::to_string(ahead_[k].number),
            "the number of a \"" + std::string(lists[k].second) + "\", at most " + std::to_string(lists[k].first));
  }

  static constexpr std::size_t unknown_part = std::numeric_limits<std::size_t>::max();

  ObjLines lines_;
  ObjModel model_;
  std::string object_, groups_;
  int material_ = -1;
  std::array<std::size_t, 4> current_{unknown_part, unknown_part, unknown_part, unknown_part};
  std::map<std::string, std::size_t> material_numbers_;
  std::map<std::tuple<std::string, std::string, int, bool, bool>, std::size_t> part_numbers_;
  std::map<std::uint32_t, Weight> weights_;
  std::array<NumberAhead, 3> ahead_;
  std::vector<LatePolygon> late_;
  std::size_t lines_left_out_ = 0, points_left_out_ = 0;
  bool has_free_forms_ = false;
  std::vector<Corner> corners_;                    // of the face that is read
  std::vector<Eigen::Vector3d> outline_;           // its positions
  std::vector<std::array<std::uint32_t, 3>> cut_;  // its triangles
};

}  // namespace

ObjModel read_obj(const std::filesystem::path& file) {
  return ObjReader(file).run();
}

}  // namespace sturm
