#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/document_kinds.h"
#include "io/files/readable_text.h"
#include "io/json/schema.h"

namespace sturm {

int validate_command(const std::vector<std::string>& files) {
  std::string text;
  for (const std::string& file : files) {
    const Json document = load_json(file);
    read_as_its_format(document, file);
    text += readable(file) + ": a valid " + document.at("format").get<std::string>() + "\n";
  }
  std::cout << text;
  return 0;
}

int schema_command(const std::string& name) {
  if (name.empty()) {
    for (const std::string& known : schema_names()) std::cout << known << "\n";
  } else {
    std::cout << schema_text(name);
  }
  return 0;
}

}  // namespace sturm
