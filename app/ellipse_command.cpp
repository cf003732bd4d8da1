#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "stages/ellipse_stage.h"

namespace sturm {

int ellipse_command(const CommonOptions& options, const std::string& output) {
  const EllipseQuery query = read_ellipse_query(load_configuration(options), options.file);
  write_result(blur_ellipses(query), output);
  return 0;
}

}  // namespace sturm
