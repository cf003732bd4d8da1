#include "app/experiment/run_folder.h"

#include <nlohmann/json.hpp>

#include "io/atomic_file.h"
#include "io/error.h"

namespace sturm {

namespace fs = std::filesystem;

RunFolder::RunFolder(fs::path folder, const std::string& key, bool resume) : folder_(std::move(folder)), parts_(folder_ / "parts" / key.substr(0, 16)) {
  try {
    fs::create_directories(folder_ / "parts");
    for (const char* report : {"report.json", "report.html", "ellipses.csv", "junit.xml"}) fs::remove(folder_ / report);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "parts"))
      if (!resume || entry.path() != parts_) fs::remove_all(entry.path());
    for (const char* name : {"psf", "images"}) fs::create_directories(folder_ / name);
    fs::create_directories(parts_);
    AtomicFile probe(folder_ / "report.json");   // creating its temporary file shows that reports can be written
  } catch (const fs::filesystem_error& error) {
    throw RuntimeFailure("the output folder cannot be used: " + std::string(error.what()));
  }
}

RunFolder::Part RunFolder::part(const std::string& name, const std::function<Json()>& make) const {
  const fs::path file = parts_ / (name + ".json");
  if (fs::exists(file)) return {load_json(file.string()), true};
  Json value = make();
  write_file_atomically(file, value.dump());
  return {std::move(value), false};
}

}  // namespace sturm
