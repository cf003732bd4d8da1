#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sturm {

/// A statement of a material: what stands behind its word, without blanks at both ends.
struct MtlStatement {
  std::string text;
  std::string place;  ///< "FILE:LINE"
};

/// A material of an MTL file as it stands there.
struct MtlMaterial {
  std::string name;        ///< all that stands behind `newmtl`
  std::string short_name;  ///< the same without a comment at its end
  std::filesystem::path defined_in;
  std::string place;                               ///< "FILE:LINE" of its `newmtl`
  std::map<std::string, MtlStatement> statements;  ///< by their words in lower case; of several the last

  /// Null where there is none of this word.
  const MtlStatement* find(const std::string& word) const {
    const auto at = statements.find(word);
    return at == statements.end() ? nullptr : &at->second;
  }
};

/// The materials of an MTL file in their order. Words are not looked at: whether a program knows them is decided where
/// they are used. Throws InputError where the file cannot be read.
std::vector<MtlMaterial> read_mtl(const std::filesystem::path& file);

/// The material that an OBJ file means by a name: the first of exactly this name, else the only one whose name is the
/// same without comments at the ends of the two lines. Null where there is none.
const MtlMaterial* find_material(const std::vector<MtlMaterial>& materials, const std::string& name);

}  // namespace sturm
