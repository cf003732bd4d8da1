#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/view_template.h"
#include "io/files/sandbox.h"
#include "server/page_server.h"

namespace sturm {

int serve_command(const CommonOptions& options, const ServeOptions& serve) {
  Json document = load_configuration(options);
  if (options.print_config) return print_configuration(document, options.file, "");
  RenderSpec spec = read_render_spec(document, options.file);
  std::string page = filled_page(view_template(serve.page_template), page_data(spec, options.file));
  enter_sandbox();
  PageServer server(std::move(page), {std::move(document), std::move(spec)});
  const int port = server.bind(serve.port);
  std::cout << "http://127.0.0.1:" << port << "/" << std::endl;
  if (!options.quiet) std::cerr << "serving; Ctrl-C ends it\n";
  server.serve();
  return 0;
}

}  // namespace sturm
