#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace coilwright::cli {

/// What a request gets.
struct Reply {
  int status = 200;  ///< of HTTP
  /// With its charset: the library presses what is of the bare type, which takes ten times as long as the answer.
  std::string type = "application/json; charset=utf-8";
  std::string text{};
};

/// What the server has under a path behind its token: "api/evaluate". The body is that of a POST; a GET has none.
struct Route {
  std::string path;
  bool post{};  ///< whether it is asked by POST, otherwise by GET
  std::function<Reply(const std::string& body)> answer;
};

/// A server of one page for one person: on 127.0.0.1 alone, for who knows its token and comes from no other origin. It
/// has its routes and reaches no file. Bodies are bounded, and so are the requests that it works on at once.
class PageServer {
 public:
  /// Takes the port or, without one, the first free one from `usual_port` on. Throws text::InputError about --port
  /// where none is free.
  PageServer(std::optional<int> port, std::string token, std::vector<Route> routes);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  static constexpr int usual_port = 8642;

  /// "http://127.0.0.1:8642/TOKEN/".
  [[nodiscard]] std::string address() const;

  /// Answers requests until a stop is asked for, then ends those that it works on.
  void run(const std::stop_token& stop);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace coilwright::cli
