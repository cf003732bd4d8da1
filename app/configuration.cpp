#include "app/configuration.h"

#include <tbb/info.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/document_kinds.h"
#include "app/eye_options.h"
#include "app/named_documents.h"
#include "app/text_answers.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/json/json_pointer_set.h"
#include "io/json/named_file.h"
#include "io/json/readable_json.h"
#include "io/specs/lens_files/lens_file.h"

namespace sturm {

namespace {

/// What a lens file of the trade would be in JSON.
Json lens_file_document(const std::string& file) {
  return {{"format", "sturm.spectacles/1"}, {"lens_file", {{"file", std::filesystem::path(file).filename().string()}}}};
}

Json loaded(const CommonOptions& options, const Json& otherwise) {
  if (options.file.empty() || options.file == command_line_source) return otherwise;
  if (!options.schema.empty())
    require_document(options.file, {shipped_kind(options.schema)}, "a file of sturm." + options.schema + "/1");
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

bool is_in_file(const CommonOptions& options) {
  return options.file != "-" && options.file != command_line_source;
}

CommonOptions with_source(const CommonOptions& options) {
  if (!options.file.empty()) return options;
  if (options.prescription.empty() && options.worn.eye.empty())
    throw InputError("", "", "no question", "the name of a file, or --rx \"-2.00 -1.50 x 30\"");
  CommonOptions result = options;
  result.file = command_line_source;
  return result;
}

int print_configuration(const Json& document, const std::string& file, const std::string& output) {
  require_answer_name(output, AnswerKind::Json);
  read_as_its_format(document, file);
  write_result(document, output);
  return 0;
}

void write_result(const Json& result, const std::string& output) {
  write_text(readable_json(result) + "\n", output);
}

void write_text(const std::string& text, const std::string& output) {
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
