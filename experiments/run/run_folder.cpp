#include "experiments/run/run_folder.h"

#include <nlohmann/json.hpp>

#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/json_text.h"

namespace sturm {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t key_digits = 16;

/// Folders of parts are named after their key; whatever else lies there belongs to somebody else and stays.
bool holds_parts(const fs::path& path) {
  const std::string name = path.filename().string();
  return fs::is_directory(path) && name.size() == key_digits &&
         name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// Parts name the pictures that belong to them under "file" or "files".
bool pictures_exist(const Json& value, const fs::path& folder) {
  if (value.is_array()) {
    for (const Json& element : value)
      if (!pictures_exist(element, folder)) return false;
  } else if (value.is_object()) {
    if (value.contains("file") && !fs::exists(folder / value["file"].get<std::string>())) return false;
    if (value.contains("files"))
      for (const Json& file : value["files"])
        if (!fs::exists(folder / file.get<std::string>())) return false;
    if (value.contains("value")) return pictures_exist(value["value"], folder);
  }
  return true;
}

/// Files that a killed run had not finished.
void clear_leftovers(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && AtomicFile::is_temporary(entry.path())) fs::remove(entry.path());
}

}  // namespace

RunFolder::RunFolder(fs::path folder, const std::string& key, bool resume, const Layout& layout)
    : folder_(std::move(folder)), parts_(folder_ / "parts" / key.substr(0, key_digits)) {
  try {
    fs::create_directories(folder_ / "parts");
    for (const std::string& report : layout.reports) fs::remove(folder_ / report);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "parts"))
      if (holds_parts(entry.path()) && (!resume || entry.path() != parts_)) fs::remove_all(entry.path());
    std::vector<fs::path> used = {parts_};
    for (const std::string& name : layout.folders) used.push_back(folder_ / name);
    for (const fs::path& place : used) {
      fs::create_directories(place);
      clear_leftovers(place);
    }
    clear_leftovers(folder_);
    AtomicFile probe(folder_ /
                     layout.reports.front());  // creating its temporary file shows that reports can be written
  } catch (const fs::filesystem_error& error) {
    throw RuntimeFailure("the output folder cannot be used: " + std::string(error.what()));
  }
}

RunFolder::Part RunFolder::part(const std::string& name, const std::function<Json()>& make) const {
  const fs::path file = parts_ / (name + ".json");
  if (fs::exists(file)) {
    Json stored = load_json(file.string());
    if (pictures_exist(stored, folder_)) return {std::move(stored), true};
  }
  Json value = make();
  write_file_atomically(file, json_text(value));
  return {std::move(value), false};
}

}  // namespace sturm
