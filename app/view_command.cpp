#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/view_template.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/specs/render_spec.h"

namespace sturm {

int view_command(const CommonOptions& options, const std::string& template_file, const std::string& output) {
  const Json document = load_configuration(options);
  if (options.print_config) return print_configuration(document, options.file, output);
  const std::filesystem::path html(output);
  if (!has_suffix(html, ".html")) throw InputError("", "--output", "\"" + output + "\"", "a name that ends in .html");
  const RenderSpec spec = read_render_spec(document, options.file);
  require_writable(html);
  std::string page = view_template(template_file);
  const PageData data = page_data(spec, options.file);
  write_file_atomically(html, filled_page(std::move(page), data));
  if (options.quiet) return 0;
  for (const Json& sentence : data.view["not_drawn"]) std::cerr << "note: " << sentence.get<std::string>() << "\n";
  return 0;
}

}  // namespace sturm
