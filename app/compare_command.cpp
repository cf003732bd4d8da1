#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/comparison.h"
#include "io/files/atomic_file.h"
#include "io/json/json_text.h"

namespace sturm {

int compare_command(const CompareOptions& options) {
  const Comparison comparison = compare_files(options);
  if (!options.maps_folder.empty()) write_maps(comparison, options.maps_folder);
  const std::string text = json_text(json_of(comparison, options), 1) + "\n";
  if (options.json_file == "-") {
    std::cout << text;
  } else {
    std::cout << table_of(comparison);
    if (!options.json_file.empty()) write_file_atomically(options.json_file, text);
  }
  return comparison.passed() ? 0 : 1;
}

}  // namespace sturm
