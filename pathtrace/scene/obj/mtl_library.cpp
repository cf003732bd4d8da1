#include "pathtrace/scene/obj/mtl_library.h"

#include "pathtrace/scene/obj/obj_lines.h"
#include "pathtrace/scene/obj/obj_words.h"

namespace sturm {

std::vector<MtlMaterial> read_mtl(const std::filesystem::path& file) {
  std::vector<MtlMaterial> materials;
  for (ObjLines lines(file); lines.next();) {
    std::string_view text = lines.text();
    const std::string word = lower_case(take_word(text));
    text = trimmed(text);
    if (word == "newmtl")
      materials.push_back({std::string(text), std::string(without_comment(text)), file, lines.place(), {}});
    else if (!materials.empty())
      materials.back().statements[word] = {std::string(text), lines.place()};
  }
  return materials;
}

const MtlMaterial* find_material(const std::vector<MtlMaterial>& materials, const std::string& name) {
  for (const MtlMaterial& material : materials)
    if (material.name == name) return &material;
  const std::string_view plain = without_comment(name);
  const MtlMaterial* found = nullptr;
  for (const MtlMaterial& material : materials) {
    if (material.short_name != plain) continue;
    if (found) return nullptr;
    found = &material;
  }
  return found;
}

}  // namespace sturm
