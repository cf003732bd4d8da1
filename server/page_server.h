#pragma once
#include <memory>
#include <string>

#include "server/served_view.h"

namespace sturm {

/// Serves a page on this machine alone (127.0.0.1), and renders what it asks for, one picture at a time.
///
///   GET /         the page
///   GET /status   {"program": "sturm", "version", "busy"}
///   POST /render  a request (read_render_request); the answer is a line of JSON for each tenth of a second,
///                 {"progress", "seconds"}, and a last one with RenderJob::result. 400 with {"error"} for a wrong
///                 request, 503 while another picture is rendered. Where the page goes away, the rendering ends.
///
/// Requests for another host name, and those that another site's page makes, are refused with 403.
class PageServer {
 public:
  PageServer(std::string page, ServedView served);
  ~PageServer();

  /// Takes a port; 0 is any that is free. Returns which. Throws RuntimeFailure where it is taken.
  int bind(int port);

  /// Serves until the program ends.
  void serve();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace sturm
