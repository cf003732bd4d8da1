#include "app/several_documents.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/configuration.h"
#include "app/document_kinds.h"
#include "io/files/error.h"

namespace sturm {

namespace {

namespace fs = std::filesystem;

constexpr const char* place_of_name = "{name}";

bool is_folder(const std::string& output) {
  std::error_code code;
  return fs::is_directory(output, code);
}

std::string with_name(const std::string& output, const std::string& name) {
  const std::size_t at = output.find(place_of_name);
  return output.substr(0, at) + name + output.substr(at + std::string_view(place_of_name).size());
}

/// The last folders of a file and its name.
std::string with_folders(const std::string& file, int folders) {
  fs::path name = document_name(file), folder = fs::path(file).parent_path();
  for (int i = 0; i < folders && folder.has_filename(); ++i, folder = folder.parent_path())
    name = folder.filename() / name;
  return name.string();
}

}  // namespace

std::string document_name(const std::string& file) {
  return file == "-" ? "standard input" : fs::path(file).stem().string();
}

std::vector<std::string> document_names(const std::vector<std::string>& files) {
  constexpr int most_folders = 8;
  std::vector<std::string> names;
  for (const std::string& file : files) {
    const auto is_shared = [&](int folders) {
      return std::any_of(files.begin(), files.end(), [&](const std::string& other) {
        return other != file && with_folders(other, folders) == with_folders(file, folders);
      });
    };
    int folders = 0;
    while (folders < most_folders && is_shared(folders)) ++folders;
    names.push_back(folders < most_folders ? with_folders(file, folders) : file);
  }
  return names;
}

CommonOptions with_one_document(const CommonOptions& options, const std::string& what) {
  if (options.files.size() > 1)
    throw InputError("", what, std::to_string(options.files.size()) + " documents", "one document");
  return options.files.empty() ? options : with_file(options, options.files.front());
}

std::vector<std::string> files_of(const CommonOptions& given) {
  return given.files.empty() ? std::vector{with_source(given).file} : given.files;
}

CommonOptions with_file(const CommonOptions& given, const std::string& file) {
  CommonOptions result = given;
  result.file = file;
  return result;
}

std::vector<std::string> outputs_of(const std::vector<std::string>& documents, const std::string& output,
                                    const std::string& ending, const std::string& option) {
  const bool folder = output.ends_with('/') || (documents.size() > 1 && is_folder(output));
  if (!folder && output.find(place_of_name) == std::string::npos) {
    if (documents.size() == 1) return {output};
    throw InputError("", option, output.empty() ? "nothing" : "\"" + output + "\"",
                     "for several documents a folder (\"seen/\"), or a name with {name} in it (\"seen_{name}.png\")");
  }
  std::vector<std::string> outputs;
  for (const std::string& document : documents) {
    const std::string name = document_name(document);
    const std::string file = folder ? (fs::path(output) / (name + ending)).string() : with_name(output, name);
    if (std::find(outputs.begin(), outputs.end(), file) != outputs.end())
      throw InputError("", option, "two documents of the name \"" + name + "\"",
                       "documents of different names, so that none is written over another");
    outputs.push_back(file);
  }
  std::error_code code;
  if (folder) fs::create_directories(output, code);  // what goes wrong shows where it is written to
  return outputs;
}

int for_each_document(const CommonOptions& options, const std::string& output, const std::string& ending,
                      const std::function<int(const CommonOptions&, const std::string&)>& answer) {
  CommonOptions one = options;
  if (options.files.empty()) return answer(one, output);
  if (options.files.size() > 1) {
    if (options.print_config) with_one_document(options, "--print-config");
    for (const std::string& file : options.files) {
      one.file = file;
      read_as_its_format(load_configuration(one), file);
    }
  }
  const std::vector<std::string> outputs = outputs_of(options.files, output, ending, "--output");
  int status = 0;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    one.file = options.files[i];
    status = std::max(status, answer(one, outputs[i]));
  }
  return status;
}

}  // namespace sturm
