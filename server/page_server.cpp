#include "server/page_server.h"

#include <httplib.h>
#include <sys/socket.h>

#include <atomic>
#include <nlohmann/json.hpp>

#include "io/files/build_info.h"
#include "io/files/error.h"
#include "io/files/readable_text.h"
#include "io/json/json_text.h"
#include "server/render_job.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

constexpr const char* loopback = "127.0.0.1";
constexpr std::size_t largest_request = 64u << 20;
constexpr std::chrono::milliseconds between_lines{100};

enum Status { bad_request = 400, forbidden = 403, wrong_media_type = 415, busy = 503 };

void answer(httplib::Response& response, const Json& body) {
  response.set_content(json_text(body) + "\n", "application/json");
}

void refuse(httplib::Response& response, Status status, const std::string& why) {
  response.status = status;
  answer(response, {{"error", why}});
}

/// The right to be the only one that renders, which `flag` says is taken.
class OnlyOne {
 public:
  explicit OnlyOne(std::atomic<bool>& flag) : flag_(flag) {}
  ~OnlyOne() { flag_ = false; }
  OnlyOne(const OnlyOne&) = delete;
  OnlyOne& operator=(const OnlyOne&) = delete;

 private:
  std::atomic<bool>& flag_;
};

struct Work {
  std::shared_ptr<OnlyOne> right;  ///< is given back before the last line, or after a job that was ended
  RenderJob job;
  Stopwatch watch;
};

bool write_line(httplib::DataSink& sink, const Json& line) {
  const std::string text = json_text(line) + "\n";
  return sink.write(text.data(), text.size());
}

}  // namespace

struct PageServer::Parts {
  std::string page;
  ServedView served;
  httplib::Server server;
  int port = 0;
  std::atomic<bool> rendering = false;

  /// A browser names the host that it was asked to visit, and the site whose page asks.
  bool is_ours(const httplib::Request& request) const {
    const std::string host = request.get_header_value("Host"), number = ":" + std::to_string(port);
    if (host != loopback + number && host != "localhost" + number) return false;
    return !request.has_header("Origin") || request.get_header_value("Origin") == "http://" + host;
  }

  void render(const httplib::Request& request, httplib::Response& response) {
    if (request.get_header_value("Content-Type") != "application/json")
      return refuse(response, wrong_media_type, "expected the content type application/json");
    if (rendering.exchange(true)) return refuse(response, busy, "another picture is being rendered");
    const auto right = std::make_shared<OnlyOne>(rendering);
    std::shared_ptr<Work> work;
    try {
      work.reset(new Work{right, RenderJob(read_render_request(request.body, served)), {}});
    } catch (const std::exception& error) {
      return refuse(response, bad_request, readable_lines(error.what()));
    }
    response.set_chunked_content_provider("application/x-ndjson", [work](std::size_t, httplib::DataSink& sink) {
      if (!work->job.over_within(between_lines))
        return write_line(sink, {{"progress", work->job.progress()}, {"seconds", work->watch.seconds()}});
      const Json result = work->job.result();
      work->right.reset();  // whoever has the last line may ask for the next picture
      if (!write_line(sink, result)) return false;
      sink.done();
      return true;
    });
  }

  void add_routes() {
    // Not the library's own, which lets a second server share the port.
    server.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_payload_max_length(largest_request);
    server.set_default_headers({{"X-Content-Type-Options", "nosniff"}, {"Cache-Control", "no-store"}});
    server.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      if (is_ours(request)) return httplib::Server::HandlerResponse::Unhandled;
      refuse(response, forbidden, "this server answers pages of its own only");
      return httplib::Server::HandlerResponse::Handled;
    });
    server.Get("/", [this](const httplib::Request&, httplib::Response& response) {
      response.set_content(page, "text/html; charset=utf-8");
    });
    server.Get("/status", [this](const httplib::Request&, httplib::Response& response) {
      answer(response, {{"program", "sturm"}, {"version", build_info().version}, {"busy", rendering.load()}});
    });
    server.Post("/render",
                [this](const httplib::Request& request, httplib::Response& response) { render(request, response); });
  }
};

PageServer::PageServer(std::string page, ServedView served) : parts_(std::make_unique<Parts>()) {
  parts_->page = std::move(page);
  parts_->served = std::move(served);
  parts_->add_routes();
}

PageServer::~PageServer() = default;

int PageServer::bind(int port) {
  if (port == 0) {
    parts_->port = parts_->server.bind_to_any_port(loopback);
  } else if (parts_->server.bind_to_port(loopback, port)) {
    parts_->port = port;
  }
  if (parts_->port <= 0) throw RuntimeFailure("port " + std::to_string(port) + " of " + loopback + " is taken");
  return parts_->port;
}

void PageServer::serve() {
  if (!parts_->server.listen_after_bind()) throw RuntimeFailure("the server could not go on listening");
}

}  // namespace sturm
