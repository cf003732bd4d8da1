#include <tbb/info.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/text_columns.h"
#include "io/files/build_info.h"
#include "io/files/error.h"
#include "io/files/formatted_text.h"
#include "io/files/machine.h"
#include "io/files/shipped_files.h"
#include "io/images/image_formats.h"
#include "io/json/manifest.h"
#include "io/json/named_file.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

/// The report, line by line: a mark, what was looked at, and what was found.
class Examination {
 public:
  void found(const std::string& what, const std::string& text) { rows_.push_back({"ok", what, text}); }
  void odd(const char* what, const std::string& text) { rows_.push_back({"note", what, text}); }
  void broken(const char* what, const std::string& text) {
    rows_.push_back({"FAIL", what, text});
    healthy_ = false;
  }
  bool healthy() const { return healthy_; }
  std::string text() const { return text_columns(rows_); }

 private:
  std::vector<std::vector<std::string>> rows_;
  bool healthy_ = true;
};

void examine_build(Examination& examination) {
  const BuildInfo& b = build_info();
  examination.found("version", std::string(b.version) + ", commit " + std::string(b.commit));
  examination.found("build", std::string(b.compiler) + ", " + std::string(b.build_type));
  examination.found("instruction set", instruction_set() + (b.native ? ", made for this kind of processor alone" : ""));
}

void examine_machine(Examination& examination) {
  const Machine machine = this_machine();
  examination.found("processor", cpu_model());
  std::string threads = std::to_string(tbb::info::default_concurrency());
  if (machine.cores) threads += " on " + std::to_string(*machine.cores) + " cores";
  examination.found("threads", threads);
  if (machine.memory_bytes)
    examination.found("memory", formatted("%.1f GiB", static_cast<double>(*machine.memory_bytes) / (1 << 30)));
}

void examine_data(Examination& examination) {
  const std::vector<fs::path> folders = shipped_folders();
  if (folders.empty()) {
    examination.broken("shipped data", "not found; STURM_DATA may name the folder that has scenes/ and views/");
    return;
  }
  for (const fs::path& folder : folders) examination.found("shipped data", folder.string());
  for (const std::string& kind : shipped_kinds()) {
    std::string names;
    for (const std::string& name : shipped_names(kind)) names += (names.empty() ? "" : ", ") + name;
    examination.found(kind, names);
  }
}

void examine_pictures(Examination& examination) {
  try {
    require_image_formats();
    examination.found("PNG, JPEG, TIFF", "readable and writable");
  } catch (const RuntimeFailure& error) {
    examination.broken("PNG, JPEG, TIFF", error.what());
  }
}

void examine_folder(Examination& examination, const char* what, const fs::path& folder) {
  if (access(folder.c_str(), W_OK) == 0)
    examination.found(what, folder.string());
  else
    examination.odd(what, folder.string() + " cannot be written to");
}

/// A program that scripts and documents use and sturm itself does not need.
void examine_tool(Examination& examination, const char* tool, const char* purpose) {
  const char* path = std::getenv("PATH");
  const std::string folders = path ? path : "";
  for (std::size_t at = 0; at < folders.size();) {
    const std::size_t end = std::min(folders.find(':', at), folders.size());
    const fs::path file = fs::path(folders.substr(at, end - at)) / tool;
    if (access(file.c_str(), X_OK) == 0) return examination.found(tool, file.string() + " (" + purpose + ")");
    at = end + 1;
  }
  examination.odd(tool, std::string("not found (") + purpose + ")");
}

}  // namespace

int doctor_command() {
  Examination examination;
  examine_build(examination);
  examine_machine(examination);
  examine_data(examination);
  examine_pictures(examination);
  std::error_code code;
  examine_folder(examination, "working directory", fs::current_path(code));
  examine_folder(examination, "temporary files", fs::temp_directory_path(code));
  examine_tool(examination, "python3", "optional: scripts that make scenes and studies");
  examine_tool(examination, "man", "optional: sturm man ellipse | man -l -");
  std::cout << examination.text();
  return examination.healthy() ? 0 : 3;
}

}  // namespace sturm
