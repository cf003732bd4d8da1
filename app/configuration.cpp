#include "app/configuration.h"

#include <tbb/info.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/document_kinds.h"
#include "app/eye_options.h"
#include "app/name_of_text.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/shipped_files.h"
#include "io/json/json_pointer_set.h"
#include "io/json/named_file.h"
#include "io/json/readable_json.h"
#include "io/json/suggest.h"
#include "io/specs/lens_files/lens_file.h"

namespace sturm {

namespace {

/// What a lens file of the trade would be in JSON.
Json lens_file_document(const std::string& file) {
  return {{"format", "sturm.spectacles/1"}, {"lens_file", {{"file", std::filesystem::path(file).filename().string()}}}};
}

/// A name that is neither a file nor that of a shipped document.
void refuse_unknown_name(const std::string& name, const std::string& schema) {
  std::error_code code;
  if (std::filesystem::exists(name, code)) return;
  if (name.find_first_not_of("0123456789.,") == std::string::npos || name == "inf")
    throw InputError(name, "", "a number", "a file; several distances have commas between: --distance 0.4,1,inf");
  if (name.find_first_of("/.") != std::string::npos) return;
  const std::vector<std::string> known = shipped_names(shipped_kind(schema));
  if (!known.empty())
    throw InputError(name, "", "No such file" + did_you_mean(name, known), "a file, or " + one_of(known));
  for (const char* kind : {"views", "lenses", "eyes", "scenes", "experiments"})
    if (shipped_document(kind, name))
      throw InputError(name, "", std::string("a name of the shipped ") + kind, "a file of sturm." + schema + "/1");
}

Json loaded(const CommonOptions& options, const Json& otherwise) {
  if (options.file.empty() || options.file == command_line_source) return otherwise;
  if (options.file != "-" && !options.schema.empty()) refuse_unknown_name(options.file, options.schema);
  return is_lens_file(options.file) ? lens_file_document(options.file) : load_json(options.file);
}

}  // namespace

Json load_configuration(const CommonOptions& options, const Json& otherwise) {
  Json document = loaded(options, otherwise);
  require_kind(document, options.schema, options.file);
  for (const std::string& assignment : options.assignments) apply_set(document, assignment);
  apply_eye_options(document, options);
  if (options.seed && document.is_object()) document["seed"] = *options.seed;
  return document;
}

CommonOptions with_source(const CommonOptions& options) {
  if (!options.file.empty()) return options;
  if (options.prescription.empty())
    throw InputError("", "", "no question", "the name of a file, or --rx \"-2.00 -1.50 x 30\"");
  CommonOptions result = options;
  result.file = command_line_source;
  return result;
}

int print_configuration(const Json& document, const std::string& file, const std::string& output) {
  require_name_of_text(output);
  read_as_its_format(document, file);
  write_result(document, output);
  return 0;
}

void write_result(const Json& result, const std::string& output) {
  write_text(readable_json(result) + "\n", output);
}

void write_text(const std::string& text, const std::string& output) {
  require_name_of_text(output);
  if (output.empty() || output == "-")
    std::cout << text;
  else
    write_file_atomically(output, text);
}

void require_writable(const std::filesystem::path& file) {
  AtomicFile probe(file);
}

int thread_count(const CommonOptions& options) {
  return options.threads > 0 ? options.threads : tbb::info::default_concurrency();
}

}  // namespace sturm
