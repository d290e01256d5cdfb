#include "cli/bench/server.hpp"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <semaphore>
#include <thread>
#include <utility>

#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

constexpr std::size_t most_at_once = 16;     // requests; further ones wait in the queue of the system
constexpr std::size_t longest_body = 65536;  // bytes: a design with every number changed has 4000
constexpr int ports_tried = 20;
constexpr time_t patience = 5;  // s, for who connects and then says nothing

// A pool that takes a connection only when a thread is free for it: what waits is bounded by the system's queue.
class BoundedPool : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> work) override {
    free_.acquire();
    pool_.enqueue([this, work = std::move(work)] {
      work();
      free_.release();
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  std::counting_semaphore<> free_{most_at_once};
  httplib::ThreadPool pool_{most_at_once};
};

// Takes as long whatever the first different letter is.
bool same_secret(std::string_view one, std::string_view other) {
  if (one.size() != other.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    different |= static_cast<unsigned>(static_cast<unsigned char>(one[i]) ^ static_cast<unsigned char>(other[i]));
  return different == 0;
}

void refuse(httplib::Response& response, int status, const char* why) {
  response.status = status;
  response.set_content(fmt::format("{{\"error\": \"{}\"}}\n", why), "application/json");
}

}  // namespace

struct PageServer::Parts {
  httplib::Server http{};
  int port{};
  std::string token;
  std::vector<Route> routes;

  // Why a request is not answered: 0 and nothing where it is. It is asked before a body is read.
  [[nodiscard]] std::pair<int, const char*> refusal(const httplib::Request& request) const {
    const std::string hosts[] = {fmt::format("127.0.0.1:{}", port), fmt::format("localhost:{}", port)};
    const std::string host = request.get_header_value("Host");
    if (std::ranges::find(hosts, host) == std::end(hosts)) return {403, "must be asked for by its own address"};
    if (request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host)
      return {403, "must be asked for by its own page"};
    const std::string start = "/" + token + "/";
    if (request.path.size() < start.size() || !same_secret(request.path.substr(0, start.size()), start))
      return {403, "must be asked for with the token of the address that coilwright bench printed"};
    const bool post = request.method == "POST";
    const auto route = std::ranges::find(routes, request.path.substr(start.size()), &Route::path);
    if (route == routes.end()) return {404, "is not here"};
    if (post != route->post || (!post && request.method != "GET")) return {405, "must be asked for the other way"};
    if (!post) return {0, nullptr};
    if (!request.get_header_value("Content-Type").starts_with("application/json"))
      return {415, "must be application/json"};
    if (!request.has_header("Content-Length") || request.has_header("Transfer-Encoding") ||
        request.has_header("Content-Encoding"))
      return {411, "must say its length"};
    if (request.get_header_value<std::uint64_t>("Content-Length") > longest_body) return {413, "is too long"};
    return {0, nullptr};
  }

  void answer(const httplib::Request& request, httplib::Response& response) const {
    const std::string path = request.path.substr(token.size() + 2);
    const Reply reply = std::ranges::find(routes, path, &Route::path)->answer(request.body);
    response.status = reply.status;
    response.set_content(reply.text, reply.type);
  }
};

PageServer::PageServer(std::optional<int> port, std::string token, std::vector<Route> routes)
    : parts_(new Parts{.token = std::move(token), .routes = std::move(routes)}) {
  httplib::Server& http = parts_->http;
  http.new_task_queue = [] { return new BoundedPool; };
  // Not the library's own choice, by which two servers could share a port.
  http.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  http.set_tcp_nodelay(true);
  http.set_keep_alive_timeout(1);  // s, which an end waits for as well
  http.set_read_timeout(patience);
  http.set_write_timeout(patience);
  http.set_payload_max_length(longest_body);
  http.set_default_headers({{"Cache-Control", "no-store"},
                            {"Referrer-Policy", "no-referrer"},
                            {"X-Content-Type-Options", "nosniff"},
                            {"Cross-Origin-Resource-Policy", "same-origin"},
                            {"Content-Security-Policy",
                             "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src "
                             "'self' data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"}});
  http.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
    const auto [status, why] = parts_->refusal(request);
    if (status == 0) return httplib::Server::HandlerResponse::Unhandled;
    refuse(response, status, why);
    response.set_header("Connection", "close");
    return httplib::Server::HandlerResponse::Handled;
  });
  const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
    parts_->answer(request, response);
  };
  http.Get(".*", answer);
  http.Post(".*", answer);
  http.set_exception_handler([](const httplib::Request&, httplib::Response& response, const std::exception_ptr&) {
    refuse(response, 500, "cannot be answered");
  });
  const int first = port.value_or(usual_port);
  for (int tried = first; tried < first + (port ? 1 : ports_tried); ++tried) {
    if (!http.bind_to_port("127.0.0.1", tried)) continue;
    parts_->port = tried;
    return;
  }
  throw text::InputError(
      {.file = "--port",
       .rule = port ? "must be a free port of 127.0.0.1"
                    : fmt::format("is needed: none of the ports {} to {} is free", first, first + ports_tried - 1),
       .value = port ? fmt::format("{}", *port) : std::string()});
}

PageServer::~PageServer() = default;

std::string PageServer::address() const {
  return fmt::format("http://127.0.0.1:{}/{}/", parts_->port, parts_->token);
}

void PageServer::run(const std::stop_token& stop) {
  std::atomic<bool> ended = false;
  // Again and again, as a server that is only about to listen does not hear it.
  const std::jthread ender([this, &ended, &stop] {
    for (; !ended; std::this_thread::sleep_for(std::chrono::milliseconds(20)))
      if (stop.stop_requested()) parts_->http.stop();
  });
  parts_->http.listen_after_bind();
  ended = true;
}

}  // namespace coilwright::cli
