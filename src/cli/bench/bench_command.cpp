#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/bench/answers.hpp"
#include "cli/bench/commands.hpp"
#include "cli/bench/diagnosis.hpp"
#include "cli/bench/server.hpp"
#include "cli/options.hpp"
#include "cli/packed_files.hpp"
#include "cli/runs/study_run.hpp"
#include "coilwright/results/build_info.hpp"
#include "coilwright/results/page/page_file.hpp"
#include "coilwright/simulation/choice_effects.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {
namespace {

using text::Json;

struct BenchOptions {
  std::string named;
  std::optional<double> current{};
  std::optional<int> port{};
  std::optional<std::string> token_file{};
  bool no_browser{false};
  bool json{false};
};

constexpr std::size_t token_length = 32;

bool is_token(const std::string& text) {
  return text.size() == token_length && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string new_token() {
  std::random_device dice;  // of the system: no seed tells the next number
  std::string out;
  while (out.size() < token_length) out += fmt::format("{:08x}", dice());
  return out;
}

// That of the file or, where there is none yet, a new one, which only its owner may read.
std::string kept_token(const std::string& file) {
  std::string token;
  if (std::ifstream in(file); in >> token) {
    if (!is_token(token)) throw text::InputError({.file = file, .rule = "must be a token that coilwright bench wrote"});
    return token;
  }
  token = new_token();
  const mode_t before = umask(077);
  std::ofstream out(file, std::ios::app);
  umask(before);
  if (!(out << token << '\n' << std::flush))
    throw text::OutputError(file, "no token can be written there", text::OutputError::Stage::preparing);
  return token;
}

// In the browser that the system calls its own; where it has none, the address that is printed is all.
void open_browser(const std::string& address) {
  std::string program = "xdg-open", argument = address;
  const std::array<char*, 3> arguments{program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_WRONLY, 0);
  pid_t child{};
  (void)posix_spawnp(&child, program.c_str(), &quiet, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&quiet);
}

Reply json_reply(const Json& json, int status = 200) {
  return {.status = status, .text = json.text()};
}

// An answer, or why there is none: 422 for what cannot be built or evaluated, 409 for what nobody waits for any more.
Reply answered(const std::function<Reply()>& answer) {
  try {
    return answer();
  } catch (const Superseded& why) {
    return json_reply(Json::object({{"error", why.what()}}), 409);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& why) {
    return json_reply(Json::object({{"error", why.what()}}), 422);
  }
}

Json about(const Bench& bench) {
  Json quantities = Json::list(simulation::standard_quantities(), [](const simulation::ResultQuantity& each) {
    return Json::object({{"name", each.name}, {"meaning", each.meaning}});
  });
  return Json::object({{"name", bench.file.name},
                       {"opened", bench.shown},
                       {"made_by", results::made_by()},
                       {"has_report", results::why_no_page().empty()},
                       {"knobs", knobs(bench)},
                       {"quantities", std::move(quantities)},
                       {"main", Json::list(simulation::main_figures)},
                       {"further", bench.further}});
}

// Everything that is asked of one bench.
std::vector<Route> routes(const Bench& bench, NewestFirst& newest, LongWork& work) {
  std::vector<Route> out;
  const auto file = [&](const char* path, std::string_view content, const char* type) {
    out.push_back({.path = path, .answer = [content, type](const std::string&) {
                     return Reply{.type = fmt::format("text/{}; charset=utf-8", type), .text = std::string(content)};
                   }});
  };
  file("", text::packed_text(bench_files(), "bench.html"), "html");
  file("bench.js", text::packed_text(bench_files(), "bench.js"), "javascript");
  file("bench.css", text::packed_text(bench_files(), "bench.css"), "css");
  file("page.css", text::packed_text(results::page_files(), "page.css"), "css");
  const auto get = [&](const char* path, std::function<Reply()> answer) {
    out.push_back(
        {.path = path, .answer = [answer = std::move(answer)](const std::string&) { return answered(answer); }});
  };
  const auto post = [&](std::string path, std::function<Reply(const Question&)> answer) {
    out.push_back({.path = std::move(path),
                   .post = true,
                   .answer = [&bench, answer = std::move(answer)](const std::string& body) {
                     return answered([&] { return answer(read_question(bench, body)); });
                   }});
  };
  get("api/bench", [&bench] { return json_reply(about(bench)); });
  get("api/work", [&work] { return json_reply(work.state()); });
  post("api/evaluate", [&](const Question& question) {
    const NewestFirst::Turn turn(newest, question.page);
    return json_reply(answer_of(bench, question.design, turn));
  });
  post("api/curves", [&](const Question& question) {
    const NewestFirst::Turn turn(newest, question.page);
    return json_reply(curves_of(bench, question.design, turn));
  });
  post("api/record", [&](const Question& question) {
    const NewestFirst::Turn turn(newest, question.page);
    return json_reply(record_of(bench, question.design, question.channel));
  });
  post("api/errors", [&](const Question& question) {
    const NewestFirst::Turn turn(newest, question.page);
    return json_reply(errors_of(bench, question.design, turn));
  });
  post("api/actuator", [&](const Question& question) { return Reply{.text = actuator_text(bench, question.design)}; });
  post("api/study", [&](const Question& question) { return Reply{.text = study_text(bench, question, 2000, false)}; });
  post("api/report", [&](const Question& question) {
    return Reply{.type = "text/html; charset=utf-8", .text = report_of(bench, question.design)};
  });
  post("api/stop", [&work](const Question&) {
    work.stop();
    return json_reply(work.state());
  });
  for (const char* kind : {"search", "limits", "yield"})
    post(fmt::format("api/{}", kind), [&, kind = std::string(kind)](const Question& question) {
      if (!work.begin(kind, work_of(bench, question, kind)))
        return json_reply(Json::object({{"error", "other work is running: stop it first"}}), 409);
      return json_reply(work.state());
    });
  return out;
}

void run_bench(const BenchOptions& options) {
  const Bench bench = open_bench(options.named, options.current);
  NewestFirst newest;
  LongWork work;
  PageServer server(options.port, options.token_file ? kept_token(*options.token_file) : new_token(),
                    routes(bench, newest, work));
  const Interruption interruption;
  if (options.json)
    std::cout << Json::object({{"address", server.address()}}).text() << std::flush;
  else
    std::cout << fmt::format("The bench of {} is at\n  {}\nCtrl-C ends it.\n", options.named, server.address())
              << std::flush;
  if (!options.no_browser) open_browser(server.address());
  server.run(interruption.token());
}

}  // namespace

void add_bench_command(CLI::App& app, Outcome&) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = add_command(app, "bench");
  command
      ->add_option("ACTUATOR.json", options->named,
                   "File of a design (actuator/1), or a folder that size, pareto, sweep or diagnose has written")
      ->required();
  add_number(*command, "--current-A", options->current, text::Rule::between(-1e6, 1e6),
             "Current in every coil to start from, A. Default: that of the operating_point of ACTUATOR.json, or what\n"
             "coils and magnets bear for good");
  add_whole_number(*command, "--port", options->port, text::Rule::between(1, 65535),
                   fmt::format("Port of 127.0.0.1 (default: the first free one from {} on)", PageServer::usual_port));
  command
      ->add_option("--token-file", options->token_file,
                   "File that keeps the token of the address, made where it is not there: with it and --port a page\n"
                   "finds its server again after an end and a new start")
      ->check(not_empty());
  add_flag(*command, "--no-browser", options->no_browser, "Only print the address");
  add_json_option(*command, options->json, "a text");
  command->footer(
      "Opens a page in the browser where every number of a design is a slider: beside it what the design then does,\n"
      "to the digit of evaluate, its limits, and one click for a search, for what limits it and for how many builds\n"
      "keep it. The server answers on 127.0.0.1 alone, and only who knows the address; it writes no file.\n\n"
      "Examples:\n"
      "  coilwright bench configs/actuators/finger.json\n"
      "  coilwright bench results/fastest_finger --port 8700 --no-browser");
  command->callback([options] { run_bench(*options); });
}

}  // namespace coilwright::cli
