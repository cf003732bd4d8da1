#include "app/configuration.h"

#include <tbb/info.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/prescription_option.h"
#include "io/files/atomic_file.h"
#include "io/json/json_pointer_set.h"
#include "io/json/json_text.h"
#include "io/specs/lens_files/lens_file.h"

namespace sturm {

namespace {

/// What a lens file of the trade would be in JSON.
Json lens_file_document(const std::string& file) {
  return {{"format", "sturm.spectacles/1"}, {"lens_file", {{"file", std::filesystem::path(file).filename().string()}}}};
}

}  // namespace

Json load_configuration(const CommonOptions& options) {
  Json document = is_lens_file(options.file) ? lens_file_document(options.file) : load_json(options.file);
  for (const std::string& assignment : options.assignments) apply_set(document, assignment);
  if (!options.prescription.empty()) apply_prescription(document, options.prescription, options.file);
  if (options.seed && document.is_object()) document["seed"] = *options.seed;
  return document;
}

void write_result(const Json& result, const std::string& output) {
  const std::string text = json_text(result, 1) + "\n";
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
