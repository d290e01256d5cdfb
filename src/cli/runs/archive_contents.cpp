#include "cli/runs/archive_contents.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>

#include "coilwright/formats/actuator/actuator_json.hpp"
#include "coilwright/results/build_info.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/text/argument.hpp"

namespace coilwright::cli {
namespace {

// How the current is set, and all else of the operating point.
std::string operation_text(const sizing::Study& study) {
  actuator::OperatingPoint point = study.operating;
  point.current = 0.0;
  std::string current = "varied";
  if (const auto* fixed = std::get_if<sizing::FixedCurrent>(&study.current))
    current = fmt::format("fixed {}", fixed->current);
  if (const auto* share = std::get_if<sizing::ShareOfLimit>(&study.current))
    current = fmt::format("share {}", share->share);
  if (std::holds_alternative<sizing::DrivenCurrent>(study.current)) current = "driven";
  return current + '\n' + formats::to_json(point).text();
}

}  // namespace

archive::Reader archive_of(const char* option, const std::string& folder) {
  try {
    return archive::Reader(std::filesystem::path(folder) / archive_name);
  } catch (const text::InputError& fault) {
    throw text::argument_error(option,
                               fmt::format("must name the folder of a run of size, pareto or sweep: {}", fault.what()));
  }
}

archive::Program this_program() {
  const results::Commit built = results::commit();
  return {.version = results::version(), .commit = built.hash, .build = built.sources};
}

std::string archive_of_another_run(const std::vector<std::string>& differences) {
  return fmt::format("holds the archive of another run ({}): --force replaces it, another --out keeps it",
                     fmt::join(differences, "; "));
}

std::string way_of(const sizing::SearchOptions& search, const results::Provenance& provenance) {
  std::string way(sizing::name_of(search.algorithm)), digests;
  if (provenance.starts.empty()) return way;
  for (const results::InputRecord& each : provenance.starts) digests += each.sha256;
  return fmt::format("{} from --start of SHA-256 {:.8}", way, results::sha256(digests));
}

archive::Contents contents_of(const results::Provenance& provenance) {
  archive::Contents contents;
  contents.command = provenance.command;
  contents.program = this_program();
  for (const results::InputRecord& input : provenance.inputs)
    contents.inputs.push_back({.file = input.file, .sha256 = input.sha256, .text = input.text});
  contents.changes = provenance.changes;
  contents.question = hash_of(provenance);
  return contents;
}

archive::Contents contents_of(const sizing::Study& study, const results::Provenance& provenance, bool builds_a_system) {
  archive::Contents contents = contents_of(provenance);
  contents.study = study.name;
  contents.physics = {.actuator = results::sha256(formats::to_json(study.base, "").text()),
                      .operation = results::sha256(operation_text(study)),
                      .systems = builds_a_system || study.spread ? contents.question : ""};
  if (provenance.seed) {
    contents.algorithm = provenance.sample.empty() ? way_of(study.search, provenance) : provenance.sample;
    contents.seed = provenance.seed;
  }
  contents.columns = archive::columns_of(study);
  return contents;
}

}  // namespace coilwright::cli
