#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/ellipse_stage.h"
#include "io/atomic_file.h"

namespace sturm {

int ellipse_command(const CommonOptions& options, const std::string& output) {
  const EllipseQuery query = read_ellipse_query(load_configuration(options), options.file);
  const std::string text = blur_ellipses(query).dump(1) + "\n";
  if (output.empty())
    std::cout << text;
  else
    write_file_atomically(output, text);
  return 0;
}

}  // namespace sturm
