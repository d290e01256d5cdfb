#include "cli/runs/run_files.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include "cli/outputs.hpp"
#include "cli/report_option.hpp"
#include "cli/runs/archive_contents.hpp"
#include "cli/runs/part_run.hpp"
#include "coilwright/formats/study/part_file.hpp"
#include "coilwright/results/provenance.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/output/output_file.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;

// A file that a run may leave in its folder, and the commands that write it; of merge it is known when it is written.
struct RunFile {
  std::string_view name;
  std::string_view commands;
};

// Those by which readers know a run come first, and go first.
constexpr std::array run_files{RunFile{"result.json", "size pareto sweep"},
                               RunFile{"diagnosis.json", "diagnose"},
                               RunFile{part_name, "size pareto sweep yield diagnose"},
                               RunFile{"seeds.json", ""},
                               RunFile{"diagnoses.csv", ""},
                               RunFile{formats::found_name, "size pareto sweep yield"},
                               RunFile{"actuator.json", "size diagnose"},
                               RunFile{"corrected_actuator.json", "diagnose"},
                               RunFile{"evaluations.csv", "size pareto"},
                               RunFile{"convergence.csv", "size pareto"},
                               RunFile{"front.csv", "pareto"},
                               RunFile{rows_name, "sweep"},
                               RunFile{"best.csv", "sweep"},
                               RunFile{builds_name, "yield"},
                               RunFile{"residuals.csv", "diagnose"},
                               RunFile{"summary.txt", "diagnose"},
                               RunFile{"next_experiment.json", "diagnose"},
                               RunFile{"next_experiment.csv", "diagnose"},
                               RunFile{results::provenance_name, "size pareto sweep diagnose"},
                               RunFile{report_name, "size pareto sweep diagnose"},
                               RunFile{archive_name, "size pareto sweep diagnose"},
                               RunFile{"archive.sqlite-wal", "size pareto sweep diagnose"},
                               RunFile{"archive.sqlite-shm", "size pareto sweep diagnose"},
                               RunFile{"archive.sqlite-journal", "size pareto sweep diagnose"}};

// What tells a folder of another purpose, and what that is.
constexpr const char* dataset_name = "dataset.json";
constexpr std::array<std::pair<const char*, const char*>, 2> other_purposes{
    {{dataset_name, "a data set"}, {"workflow.makeflow", "a workflow"}}};

bool is_there(const fs::path& file) {
  std::error_code none;
  return fs::exists(fs::symlink_status(file, none));
}

// Files that a data set names, where this program made it: a person's records are no one's to remove.
std::vector<std::string> records_of_ours(const fs::path& folder) {
  std::vector<std::string> out;
  try {
    const text::Document made = text::read_json(folder / results::provenance_name);
    const auto command = made.root().find("command");
    if (!command || !(command->text() == "twin" || command->text().starts_with("rig "))) return {};
    const text::Document set = text::read_json(folder / dataset_name);
    const auto runs = set.root().find("runs");
    if (!runs) return {};
    for (const text::Node& run : runs->elements())
      for (const char* key : {"file", "input_file"})
        if (const auto file = run.find(key)) out.push_back(file->text());
  } catch (const text::InputError&) {
    return {};  // none of ours
  }
  std::erase_if(out, [](const std::string& name) { return fs::path(name).filename() != name; });
  return out;
}

}  // namespace

bool is_of_archive(std::string_view name) {
  return name.starts_with(archive_name);
}

bool is_left_by(std::string_view command, std::string_view name) {
  const auto* const file = std::ranges::find(run_files, name, &RunFile::name);
  return file != run_files.end() && file->commands.find(command) != std::string_view::npos;
}

std::vector<fs::path> run_files_in(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const RunFile& each : run_files) out.push_back(folder / each.name);
  return out;
}

std::vector<fs::path> files_of_part_in(const fs::path& folder) {
  constexpr std::array<std::string_view, 3> not_listed{part_name, formats::found_name, report_name};
  std::vector<fs::path> out;
  for (const RunFile& each : run_files)
    if (!is_of_archive(each.name) && std::ranges::find(not_listed, each.name) == not_listed.end() &&
        is_there(folder / each.name))
      out.push_back(folder / each.name);
  return out;
}

void keep_other_run(const fs::path& folder, const std::function<bool(std::string_view name)>& own, bool force) {
  for (const auto& [name, purpose] : other_purposes)
    if (!own(name) && is_there(folder / name))
      throw text::OutputError(folder / name, std::string("it makes the folder ") + purpose + "; take another --out",
                              text::OutputError::Stage::preparing);
  if (force) return;
  for (const fs::path& file : run_files_in(folder)) {
    const std::string name = file.filename().string();
    if (!own(name) && is_there(file) && (name != report_name || has_mark(file, page_mark))) throw other_content(file);
  }
}

void keep_other_run(const fs::path& folder, std::string_view command, bool force) {
  keep_other_run(
      folder, [command](std::string_view name) { return is_left_by(command, name); }, force);
}

void remove_other_run(text::OutputFolder& folder, std::string_view key) {
  const bool is_shown = folder.is_unchanged(key) || !has_mark(folder.path() / report_name, page_mark);
  for (const RunFile& each : run_files)
    if (!is_of_archive(each.name) && (each.name != report_name || !is_shown)) folder.remove(each.name);
}

void remove_other_archive(text::OutputFolder& folder) {
  if (!is_there(folder.path() / archive_name)) return;  // without it, what has the name of its log is a person's
  for (const RunFile& each : run_files)
    if (is_of_archive(each.name)) folder.remove(each.name);
}

void take_folder(text::OutputFolder& folder, std::string_view key, bool force) {
  keep_others(folder, force);
  const auto own = [&](std::string_view name) {
    return folder.has(name) || name == results::provenance_name || (name == report_name && folder.is_unchanged(key));
  };
  keep_other_run(folder.path(), own, force);
  if (!force) return;
  if (folder.has(dataset_name))
    for (const std::string& record : records_of_ours(folder.path())) folder.remove(record);
  remove_other_run(folder, "");
  remove_other_archive(folder);
}

}  // namespace coilwright::cli
