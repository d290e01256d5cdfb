#include "coilwright/formats/data/dataset_draft.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "coilwright/formats/data/run_file.hpp"
#include "coilwright/measurement/data/repeated_runs.hpp"
#include "coilwright/text/one_line.hpp"
#include "formats/data/layout_format.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using measurement::data::Run;
using measurement::data::RunKind;

struct DraftedRun {
  std::string file;  // from the folder of the document
  LayoutGuess guess;
  std::optional<Run> read{};  // where its layout is known
  bool validate{};
  std::vector<std::string> asked{};
};

std::string path_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code none;
  const auto relative = std::filesystem::relative(file, folder.empty() ? "." : folder, none);
  return none || relative.empty() ? std::filesystem::absolute(file).string() : relative.string();
}

// The folder in which the set stands, as people call their rig or their day; that of its records where it has no name.
std::string name_in(const std::filesystem::path& folder, const std::filesystem::path& file) {
  for (const std::filesystem::path& each : {folder, file.parent_path()}) {
    const auto whole = (std::filesystem::absolute(each) / "").lexically_normal().parent_path();
    if (whole.has_filename()) return one_line(whole.filename().string());
  }
  return "records";
}

// Reads the run as it would be read then, and mends what reading it shows.
void try_to_read(DraftedRun& run, const std::filesystem::path& file) {
  RunEntry entry{.name = run.file, .kind = run.guess.kind, .layout = {.layout = run.guess.layout}};
  try {
    RunFile read = read_run(file, entry);
    run.read = std::move(read.run);
    if (!read.objection) return;
    if (const auto& wrapped = read.objection->wrapped) {
      std::erase_if(run.guess.layout.columns, [&](const CsvColumn& each) { return each.source == wrapped->source; });
      run.guess.layout.columns.push_back(*wrapped);
      run.guess.guessed.push_back(
          fmt::format("{} wraps, and is put together by \"wraps_deg\"; its zero may be elsewhere "
                      "than the model's (\"offset\")",
                      in_quotes(wrapped->source)));
    } else {
      run.asked.emplace_back(read.objection->error.what());
    }
  } catch (const InputError& error) {
    if (run.guess.asked.empty()) run.asked.emplace_back(error.what());
  }
}

DraftedRun drafted(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const CsvForm form = read_csv_form(file);
  DraftedRun run{.file = path_from(folder, file), .guess = guess_layout(form)};
  try_to_read(run, file);
  if (run.guess.kind != RunKind::transient || (run.read && !measurement::data::nothing_moves(*run.read))) return run;
  // The record of an instrument at rest needs no input.
  DraftedRun still{.file = run.file, .guess = run.guess};
  still.guess.kind = RunKind::still;
  if (!run.read) still.guess = guess_layout(form, {.kind = RunKind::still});
  try_to_read(still, file);
  if (!still.read || !measurement::data::nothing_moves(*still.read)) return run;
  still.guess.guessed.emplace_back("nothing moves in it: it shows the noise (\"kind\": \"still\")");
  return still;
}

// Of motions that were recorded more than once the last record is kept from the fit, which then lacks none of them.
void choose_roles(std::vector<DraftedRun>& drafts, std::vector<std::string>& guessed) {
  std::vector<Run> motions;
  std::vector<DraftedRun*> of;
  for (DraftedRun& each : drafts)
    if (each.read && each.guess.kind == RunKind::transient) {
      motions.push_back(*each.read);
      of.push_back(&each);
    }
  const std::vector<std::size_t> experiments = measurement::data::experiments_of(motions);
  bool held_out = false;
  for (std::size_t first = 0; first < motions.size(); ++first) {
    std::size_t last = experiments.size() - 1;
    while (last > first && experiments[last] != first) --last;
    if (last == first) continue;
    DraftedRun& repeat = *of[last];
    repeat.validate = held_out = true;
    guessed.push_back(
        fmt::format("{} repeats {}, and is kept from the fit (\"validate\")", repeat.file, of[first]->file));
  }
  if (!held_out && motions.size() > 1)
    guessed.emplace_back(
        "no motion is there twice: diagnose keeps every fourth run from the fit, and with it a motion that no other "
        "shows; say by \"role\" which");
}

Json drafted_json(const DraftedRun& run) {
  Json out = Json::object({{"file", run.file}, {"kind", name_of(run.guess.kind)}});
  if (run.guess.kind != RunKind::still) out.set("role", run.validate ? "validate" : "fit");
  if (run.guess.kind == RunKind::transient)
    out.set("drive", name_of(run.guess.drive)).set("start", name_of(measurement::data::Start::at_rest));
  return out;
}

// A sentence about files: once where it is of all.
void add(std::vector<std::string>& out, const std::vector<DraftedRun>& runs,
         const std::vector<std::string>& (*of)(const DraftedRun&)) {
  std::vector<std::pair<std::string, std::vector<std::string>>> by_sentence;
  for (const DraftedRun& run : runs)
    for (const std::string& sentence : of(run)) {
      const auto found = std::ranges::find(by_sentence, sentence, &decltype(by_sentence)::value_type::first);
      if (found == by_sentence.end())
        by_sentence.push_back({sentence, {run.file}});
      else
        found->second.push_back(run.file);
    }
  for (const auto& [sentence, files] : by_sentence)
    out.push_back(files.size() == runs.size() ? sentence : fmt::format("{}: {}", fmt::join(files, ", "), sentence));
}

}  // namespace

DatasetDraft draft_dataset(std::span<const std::filesystem::path> files, const std::filesystem::path& folder,
                           const std::string& actuator) {
  std::vector<DraftedRun> runs;
  for (const std::filesystem::path& file : files) runs.push_back(drafted(file, folder));
  DatasetDraft out;
  choose_roles(runs, out.guessed);
  out.document =
      Json::object({{"format", "measured-data/1"}, {"name", name_in(folder, files.front())}, {"actuator", actuator}});
  const bool alike = std::ranges::all_of(
      runs, [&](const DraftedRun& run) { return pasted(run.guess.layout) == pasted(runs.front().guess.layout); });
  if (alike) out.document = with_layout(std::move(out.document), runs.front().guess.layout);
  Json list = Json::array();
  for (const DraftedRun& run : runs) {
    Json entry = drafted_json(run);
    list.add(alike ? std::move(entry) : with_layout(std::move(entry), run.guess.layout));
  }
  out.document.set("runs", std::move(list));
  const bool moves =
      std::ranges::any_of(runs, [](const DraftedRun& run) { return run.guess.kind == RunKind::transient; });
  add(out.guessed, runs, [](const DraftedRun& run) -> const std::vector<std::string>& { return run.guess.guessed; });
  if (moves)
    out.guessed.emplace_back(
        "every motion starts at rest under its first input: \"start\": \"free\" where it does not");
  add(out.asked, runs, [](const DraftedRun& run) -> const std::vector<std::string>& { return run.guess.asked; });
  for (const DraftedRun& run : runs) out.asked.insert(out.asked.end(), run.asked.begin(), run.asked.end());
  return out;
}

}  // namespace coilwright::formats
