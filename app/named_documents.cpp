#include "app/named_documents.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "io/files/error.h"
#include "io/files/shipped_files.h"
#include "io/files/text_encoding.h"
#include "io/json/named_file.h"
#include "io/json/suggest.h"
#include "io/specs/prescription_notation.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

bool is_prescription(const std::string& text) {
  const std::string typed = with_keyboard_signs(text);
  if (typed.find_first_of("+- ") == std::string::npos || typed.find_first_of("0123456789") == std::string::npos)
    return false;
  try {
    return !parse_prescription_notation(text).empty();
  } catch (const std::invalid_argument&) {
    return false;
  }
}

void refuse_values(const std::string& name) {
  if (with_keyboard_signs(name).find_first_not_of("0123456789.,+-") == std::string::npos || name == "inf")
    throw InputError(name, "", "a number",
                     "a file; several distances have commas between (--distance 0.4,1,inf), and a prescription stands "
                     "between quotes (--rx \"-2.00 -1.50 x 30\")");
  if (is_prescription(name))
    throw InputError(name, "", "a prescription", "a file; prescriptions stand behind --rx: --rx \"" + name + "\"");
}

std::vector<std::string> names_of(const std::vector<std::string>& kinds) {
  std::vector<std::string> names;
  for (const std::string& kind : kinds)
    if (!kind.empty())
      for (const std::string& name : shipped_names(kind)) names.push_back(name);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace

void require_document(const std::string& name, const std::vector<std::string>& kinds, const std::string& what) {
  std::error_code code;
  if (name == "-" || fs::exists(name, code)) return;
  refuse_values(name);
  const std::vector<std::string> known = names_of(kinds);
  const std::string expected = known.empty() ? what : what + ", or " + one_of(known);
  if (name.find_first_of("/.") != std::string::npos) {
    const std::string stem = fs::path(name).stem().string();
    if (std::find(known.begin(), known.end(), stem) == known.end()) return;
    throw InputError(name, "", "No such file (did you mean the shipped \"" + stem + "\"?)", expected);
  }
  for (const std::string& kind : shipped_kinds())
    if (shipped_document(kind, name)) throw InputError(name, "", "a name of the shipped " + kind, expected);
  if (!known.empty()) throw InputError(name, "", "No such file" + did_you_mean(name, known), expected);
}

}  // namespace sturm
