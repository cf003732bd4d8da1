#include "app/configuration.h"

#include <tbb/info.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "io/files/atomic_file.h"
#include "io/json/json_pointer_set.h"
#include "io/json/json_text.h"

namespace sturm {

Json load_configuration(const CommonOptions& options) {
  Json document = load_json(options.file);
  for (const std::string& assignment : options.assignments) apply_set(document, assignment);
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
