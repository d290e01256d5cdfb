#include "cli/command_line.hpp"

#include <cxxabi.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <typeinfo>
#include <vector>

#include "cli/command_tree.hpp"
#include "cli/other_format.hpp"
#include "cli/programs.hpp"
#include "cli/report_option.hpp"
#include "coilwright/results/build_info.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/output/output_file.hpp"
#include "coilwright/text/output/plain_output.hpp"
#include "coilwright/text/spelling.hpp"

namespace coilwright::cli {
namespace {

constexpr std::size_t longest_message = 2000;

// How an error is told: a line for a person or, where the arguments ask for JSON, an object for a program.
enum class ErrorFormat { line, json };

ErrorFormat error_format_of(std::span<const char* const> arguments) {
  const bool json = std::ranges::any_of(arguments, [](std::string_view each) { return each == "--json"; });
  return json ? ErrorFormat::json : ErrorFormat::line;
}

text::Json line_or_null(const std::string& part) {
  return text::text_or_null(text::one_line(part, longest_message));
}

// What is told of an error.
std::string told(ErrorFormat format, ExitCode code, std::string_view message, const text::Fault& fault = {}) {
  const std::string line = text::one_line(message, longest_message);
  if (format == ErrorFormat::line) return fmt::format("coilwright: {}\n", line);
  using text::Json;
  // What is said of an option has it where others have their file.
  const bool of_option = fault.file.starts_with("--");
  return Json::object({{"error", Json::object({{"exit_code", static_cast<int>(code)},
                                               {"message", line},
                                               {"file", line_or_null(of_option ? "" : fault.file)},
                                               {"place", line_or_null(of_option ? fault.file : fault.place)},
                                               {"rule", line_or_null(fault.rule)},
                                               {"value", line_or_null(fault.value)}})}})
      .text();
}

ExitCode fail(ErrorFormat format, ExitCode code, std::string_view message, const text::Fault& fault = {}) {
  std::cerr.clear();  // progress that could not be written must not keep this back
  std::cerr << told(format, code, message, fault);
  return code;
}

// Made before the work, because there is no memory for it then; global, because nothing else reaches a terminate
// handler.
std::string out_of_memory;
std::atomic_flag is_told;
std::terminate_handler terminate_otherwise = nullptr;

// By the first of several threads alone, for whose line the others wait.
void tell_out_of_memory() {
  if (is_told.test_and_set()) {
    ::sleep(1);
    return;
  }
  [[maybe_unused]] const ssize_t said = ::write(STDERR_FILENO, out_of_memory.data(), out_of_memory.size());
}

// Memory may fail where nothing can be thrown: under a library in C, in what clears up after another error, in the
// telling of it. Functions of the standard library that throw nothing (std::filesystem's with an error_code) then end
// the program without an exception that could be asked, and nothing else in this program does.
[[noreturn]] void end_out_of_memory() {
  const std::type_info* thrown = abi::__cxa_current_exception_type();
  if (thrown == nullptr || *thrown == typeid(std::bad_alloc)) {
    tell_out_of_memory();
    std::_Exit(static_cast<int>(ExitCode::failure));
  }
  terminate_otherwise();
  std::abort();
}

// The command that the arguments chose (`rig torque-bench` is one below another), or the program itself.
const CLI::App& chosen(const CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : chosen(*commands.front());
}

std::string unknown_option(const CLI::App& command, std::string_view argument) {
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  }
  const std::string_view name = argument.substr(0, argument.find('='));  // --stpe=3
  return "unknown option " + text::in_quotes(name) + text::did_you_mean(name, options);
}

// The first unrecognised argument: an option, if there is one, for what stands behind it may have been meant for it.
// Nothing where all was taken.
std::optional<std::string> unexpected_argument(const CLI::App& app) {
  const auto left = app.remaining(true);
  if (left.empty()) return std::nullopt;
  const auto option = std::ranges::find_if(left, [](const std::string& each) { return each.starts_with('-'); });
  if (option != left.end()) return unknown_option(chosen(app), *option);
  return "unexpected argument " + text::in_quotes(left.front());
}

// About one command, or about the program itself.
ExitCode usage_error(ErrorFormat format, const CLI::App& command, std::string_view message) {
  const std::string name = name_of(command);
  const std::string program = "coilwright";
  const std::string prefix = name == program ? "" : name.substr(program.size() + 1) + ": ";
  return fail(format, ExitCode::bad_input, fmt::format("{}{} (see {} --help)", prefix, message, name));
}

// CLI11 says of a mistyped command only that it was not expected. Nothing where the arguments name one.
std::optional<ExitCode> mistaken_command(ErrorFormat format, const CLI::App& app,
                                         std::span<const char* const> arguments) {
  const auto names = command_names(app);
  if (names.empty()) return std::nullopt;
  if (arguments.empty())
    return usage_error(format, app, fmt::format("a command is needed: {}", fmt::join(names, ", ")));
  const std::string_view first = arguments.front();
  if (first.starts_with('-')) {
    if (app.get_option_no_throw(std::string(first)) != nullptr) return std::nullopt;
    return usage_error(format, app, unknown_option(app, first));
  }
  const auto found = app.get_subcommands([first](const CLI::App* each) { return each->get_name() == first; });
  if (found.empty() || first.empty()) return usage_error(format, app, unknown_command(first, names));
  return mistaken_command(format, *found.front(), arguments.subspan(1));
}

// CLI11's own words of a slip, but for one that they tell in the words of a programmer: "as-written was given a
// disallowed flag override".
std::string usage_message(const CLI::ParseError& error) {
  const std::string words = error.what();
  const std::size_t end = words.find(" was given a disallowed flag override");
  return end == std::string::npos ? words : fmt::format("--{}: takes no value", words.substr(0, end));
}

// The words of the system, which TBB's own end with, in whichever step wanted a further thread.
bool is_out_of_threads(const std::exception& error) {
  return std::string_view(error.what()).ends_with(std::generic_category().message(EAGAIN));
}

ExitCode out_of_threads(ErrorFormat format) {
  return fail(format, ExitCode::failure,
              "no further thread can be started: the limit of processes (ulimit -u) or of memory is reached");
}

// The command that the arguments are about: the first of them, or what `help` is asked of.
std::string_view subject_of(std::span<const char* const> arguments) {
  if (arguments.size() < 2) return {};
  const bool explains = std::string_view(arguments[1]) == "help" && arguments.size() > 2;
  return arguments[explains ? 2 : 1];
}

ExitCode parse_and_run(CLI::App& app, std::span<const char* const> arguments, const Outcome& outcome) {
  const ErrorFormat format = error_format_of(arguments);
  try {
    if (const CommandPlace* place = place_of(subject_of(arguments)); place != nullptr && is_elsewhere(app, place->name))
      go_on_in(place->program, arguments);
    std::vector<std::string> words = with_named_pages(arguments.subspan(std::min<std::size_t>(1, arguments.size())));
    std::ranges::reverse(words);  // as CLI11 takes them
    app.parse(std::move(words));
  } catch (const CLI::Success& help_or_version) {
    app.exit(help_or_version, std::cout, std::cerr);
  } catch (const CLI::ParseError& error) {
    // What is missing may be missing because its option was misspelt.
    return usage_error(format, chosen(app), unexpected_argument(app).value_or(usage_message(error)));
  } catch (const text::InputError& error) {
    if (is_out_of_threads(error)) return out_of_threads(format);
    const text::InputError said = with_next_step(error);
    return fail(format, ExitCode::bad_input, said.what(), said.fault());
  } catch (const text::OutputError& error) {
    const bool before_the_work = error.stage() == text::OutputError::Stage::preparing;
    return fail(format, before_the_work ? ExitCode::bad_input : ExitCode::failure, error.what());
  } catch (const std::bad_alloc&) {
    tell_out_of_memory();
    return ExitCode::failure;
  } catch (const std::filesystem::filesystem_error& error) {
    const text::InputError told(
        {.file = error.path1().string(), .rule = "cannot be looked at: " + error.code().message()});
    return fail(format, ExitCode::bad_input, told.what(), told.fault());
  } catch (const OtherMachine& error) {
    return fail(format, ExitCode::other_machine, error.what());
  } catch (const std::exception& error) {
    if (is_out_of_threads(error)) return out_of_threads(format);
    return fail(format, ExitCode::failure, error.what());
  }
  std::cout.flush();
  if (!std::cout) return fail(format, ExitCode::failure, "standard output cannot be written");
  return outcome.code;
}

// All commands in the order of the help: those of this program whole, of others the name and its line.
void add_commands(CLI::App& app, Outcome& outcome, std::span<const Command> commands) {
  for (const CommandPlace& place : command_places()) {
    const auto own = std::ranges::find(commands, place.name, &Command::name);
    if (own == commands.end())
      add_command(app, place.name)->prefix_command();
    else
      own->add(app, outcome);
  }
  for (const AddCommand add :
       {&add_help_command, &add_version_command, &add_completion_command, &add_man_command, &add_describe_command})
    add(app, outcome);
}

}  // namespace

CLI::App* add_command(CLI::App& app, std::string_view name) {
  return app.add_subcommand(std::string(name), std::string(place_of(name)->help));
}

ExitCode run(std::span<const char* const> arguments, std::span<const Command> commands) {
  const ErrorFormat format = error_format_of(arguments);
  out_of_memory = told(format, ExitCode::failure, "out of memory: --threads 1 takes the least");
  if (std::get_terminate() != end_out_of_memory) terminate_otherwise = std::set_terminate(end_out_of_memory);
  CLI::App app("Sizes soft electromagnetic bending actuators and identifies which physical effect a model lacks.",
               "coilwright");
  app.set_version_flag("-V,--version", &results::version_text,
                       "Print the version, the commit and the libraries, and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.require_subcommand(1);
  app.footer(
      "coilwright help COMMAND explains a command and shows an example.\n\n"
      "Exit codes: 0 done; 1 another failure; 2 bad input or usage; 3 no feasible design; 4 a part that must be\n"
      "made on another machine; 130 interrupted.");
  Outcome outcome{.arguments = arguments};
  add_commands(app, outcome, commands);

  if (const auto mistake = mistaken_command(format, app, arguments.subspan(std::min<std::size_t>(1, arguments.size()))))
    return *mistake;
  return parse_and_run(app, arguments, outcome);
}

namespace {

// By default each thread of glibc's reserves 64 MB of addresses for its heap. Where that is not to be had, every
// allocation of the thread is a page of its own from the system: 240 s for the work of 4. One heap for all threads
// takes what there is, and fails where there is no more.
void share_heap_where_addresses_are_few() {
#ifdef M_ARENA_MAX
  rlimit addresses{};
  if (getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur != RLIM_INFINITY) mallopt(M_ARENA_MAX, 1);
#endif
}

}  // namespace

int program(int argc, char** argv, std::span<const Command> commands) {
  // A file that may grow no further (ulimit -f) is then an error of the writing, told as a full disk is, and no death.
  std::signal(SIGXFSZ, SIG_IGN);
  share_heap_where_addresses_are_few();
  const text::PlainOutput out(std::cout, isatty(STDOUT_FILENO) == 1);
  const text::PlainOutput errors(std::cerr, isatty(STDERR_FILENO) == 1);
  (void)results::sha256({});  // OpenSSL reads through a null pointer where memory fails while it makes itself ready
  return static_cast<int>(run({argv, static_cast<std::size_t>(argc)}, commands));
}

}  // namespace coilwright::cli
