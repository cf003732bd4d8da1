#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands.h"
#include "app/configuration.h"
#include "io/files/plain_file.h"
#include "io/files/sandbox.h"
#include "server/page_server.h"

namespace sturm {

int serve_command(const CommonOptions& options, const ServeOptions& serve) {
  Json document = load_configuration(options);
  RenderSpec spec = read_render_spec(document, options.file);
  require_plain_file(serve.page, "the page of the viewer");
  std::ostringstream page;
  page << std::ifstream(serve.page, std::ios::binary).rdbuf();
  enter_sandbox();
  PageServer server(page.str(), {std::move(document), std::move(spec)});
  const int port = server.bind(serve.port);
  std::cout << "http://127.0.0.1:" << port << "/" << std::endl;
  if (!options.quiet) std::cerr << "serving; Ctrl-C ends it\n";
  server.serve();
  return 0;
}

}  // namespace sturm
