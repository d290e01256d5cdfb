#include "cli/runs/part_run.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <variant>
#include <vector>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "cli/runs/archive_contents.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/sizing/study/sweep.hpp"
#include "coilwright/text/output/output_folder.hpp"

namespace coilwright::cli {
namespace {

std::optional<sizing::Part> part_in(const std::string& text) {
  sizing::Part part;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, part.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto of = std::from_chars(number.ptr + 1, end, part.of);
  if (of.ec != std::errc() || of.ptr != end) return std::nullopt;
  if (part.number < 1 || part.number > part.of || part.of > sizing::most_parts_of_a_run) return std::nullopt;
  return part;
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "processor unknown";
}

text::Json figures_of(const sizing::EvaluatedDesign& design) {
  return text::Json::list(simulation::standard_quantities(), [&](const simulation::ResultQuantity& quantity) {
    return text::number_or_null(quantity.value(design.view()));
  });
}

text::Json figures_of(const sizing::DesignResult& result) {
  if (const auto* none = std::get_if<sizing::NotEvaluated>(&result)) return none->reason;
  return figures_of(std::get<sizing::EvaluatedDesign>(result));
}

formats::Machine machine_with(const text::Json& figures) {
  utsname system{};
  uname(&system);
  return {.host = system.nodename, .processor = processor_name(), .figures = figures.text()};
}

constexpr std::size_t replayed_designs = 3;

}  // namespace

void add_part_options(CLI::App& command, PartOptions& options, const std::string& what) {
  const auto complaint = [](const std::string& text) {
    if (part_in(text)) return std::string();
    return fmt::format("must be K/N with 1 <= K <= N <= {}, as in 3/40; got {}", sizing::most_parts_of_a_run, text);
  };
  const auto take = [&options](const std::string& text) { options.part = part_in(text); };
  CLI::Option* part = command.add_option_function<std::string>(
      "--part", take, what + ", K/N as in 3/40, and write part.json for merge (see coilwright distribute)");
  part->check(CLI::Validator(complaint, ""));
  for (const char* of_whole : {"--json", "--report"})
    if (CLI::Option* option = command.get_option_no_throw(of_whole)) part->excludes(option);
  command
      .add_option(
          "--head", options.head,
          "head.json of the machine that gathers the parts: first evaluate three designs, and end where one has "
          "other numbers here than there")
      ->needs(part);
}

std::string part_text(const PartOptions& options) {
  return options.part ? fmt::format(" --part {}/{}", options.part->number, options.part->of) : "";
}

formats::Machine this_machine(const sizing::DesignProblem& problem) {
  const auto points = sizing::sampled_points(problem, {.drawn = replayed_designs, .seed = 1});
  return machine_with(
      text::Json::list(points, [&](const std::vector<double>& point) { return figures_of(problem.evaluate(point)); }));
}

formats::Machine this_machine() {
  using enum actuator::Configuration;
  text::Json figures = text::Json::array();
  for (const actuator::Configuration configuration : {A, B, C})
    figures.add(figures_of(
        simulation::evaluate(actuator::Design{.layout = actuator::layout_of(configuration)}, {.current = 1.0})));
  return machine_with(figures);
}

void require_figures_of_head(const PartOptions& options, const formats::Machine& here) {
  if (options.head.empty()) return;
  const formats::Machine head = formats::read_head(options.head);
  if (head.figures == here.figures) return;
  throw OtherMachine(
      fmt::format("{} gives three designs other numbers than {}, where the parts are gathered: their results must not "
                  "be mixed; make the parts on processors of one kind",
                  here.name(), head.name()));
}

std::optional<formats::PartFile> begin_search_part(const PartOptions& options, results::Provenance provenance,
                                                   sizing::Study& study) {
  if (!options.part) return std::nullopt;
  const sizing::SearchOptions& search = study.search;
  provenance.seed = search.seed;
  const bool is_whole = search.afterwards == sizing::Afterwards::sensitivity;
  formats::PartFile out{.part = *options.part,
                        .whole = whole_of(provenance, study.name,
                                          fmt::format("{}, {} evaluations{}", way_of(search, provenance),
                                                      search.max_evaluations, is_whole ? "" : ", --answer-only")),
                        .machine = this_machine(sizing::DesignProblem(study))};
  require_figures_of_head(options, out.machine);
  study.search.seed += options.part->number - 1;
  return out;
}

archive::Contents whole_of(const results::Provenance& provenance, const std::string& study, std::string how) {
  archive::Contents whole{.command = provenance.command, .study = study, .program = this_program()};
  for (const results::InputRecord& input : provenance.inputs)
    whole.inputs.push_back({.file = input.file, .sha256 = input.sha256, .text = input.text});
  whole.changes = provenance.changes;
  whole.algorithm = std::move(how);
  whole.seed = provenance.seed;
  return whole;
}

void write_part(text::OutputFolder& folder, formats::PartFile part, std::optional<text::Json> results) {
  part.files.clear();
  for (const std::filesystem::path& file : files_of_part_in(folder.path()))
    part.files.push_back(
        {.name = file.filename().string(), .bytes = file_size(file), .sha256 = results::sha256_of_file(file)});
  if (results) {
    const std::string found =
        formats::found_json(results::sha256(formats::to_json(part).text()), *std::move(results)).text();
    if (found.size() > text::json_size_limit)
      throw std::runtime_error(
          fmt::format("{}: keeps so many designs that {} would be longer than {} MB: take more "
                      "parts, or --keep feasible",
                      printed(folder.path()), formats::found_name, text::json_size_limit / 1'000'000));
    part.files.push_back({.name = formats::found_name, .bytes = found.size(), .sha256 = results::sha256(found)});
    folder.write(formats::found_name, found);
  }
  folder.write(part_name, formats::to_json(part).text());
  folder.commit(part_name);
  std::cout << fmt::format("{}: part {} of {} of {} {}\n", printed(folder.path()), part.part.number, part.part.of,
                           part.whole.command, part.whole.study);
}

}  // namespace coilwright::cli
