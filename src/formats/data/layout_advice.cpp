
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "coilwright/formats/data/dataset_draft.hpp"
#include "coilwright/text/one_line.hpp"
#include "formats/data/layout_format.hpp"

namespace coilwright::formats {
namespace {

using namespace text;

constexpr std::size_t most_names = 12;

// Where the keys go, so that they replace nothing that other runs need.
std::string place(const RunEntry& entry, const FileLayout& file) {
  if (&file != &entry.layout) return R"(in "input_file" of its run, {"file": .., HERE})";
  const CsvLayout& layout = file.layout;
  const bool bare = layout.columns.empty() && layout.markers.empty() && layout.ignore.empty() &&
                    !layout.ignore_others && !layout.sampling_rate;
  return bare ? R"(beside "runs" for all runs)" : R"(in the entry of this run)";
}

std::string column_names_of(const CsvForm& form) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < form.names.size() && i < most_names; ++i)
    names.push_back(form.names[i].empty() ? fmt::format("#{}", i + 1) : in_quotes(form.names[i]));
  if (form.names.size() > most_names) names.emplace_back("..");
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string pasted(const CsvLayout& layout) {
  const std::string json = with_layout(Json::object(), layout).text();
  std::string line;
  // A line end in a text is written as \n: those that are there are the writer's.
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] != '\n') {
      line += json[i];
      continue;
    }
    if (line.ends_with(',')) line += ' ';
    while (i + 1 < json.size() && json[i + 1] == ' ') ++i;
  }
  return line.size() >= 2 ? line.substr(1, line.size() - 2) : line;
}

InputError advised(const InputError& error, const CsvHeader& header, const RunEntry& entry, const FileLayout& layout,
                   const std::function<bool(CsvHeader&)>& accepts) {
  Fault fault = error.fault();
  const CsvForm& form = header.form();
  // Of two columns of one name a person knows which is meant.
  if (form.sample.empty() || fault.rule == "must not be there twice") return error;
  const bool of_run = &layout == &entry.layout;
  const LayoutGuess guess =
      guess_layout(form, {.kind = entry.kind, .input = !of_run || !entry.input_file, .measured = of_run});
  CsvHeader trial(header.file(), form, guess.layout);
  const std::string written = pasted(guess.layout);
  if (!written.empty() && accepts(trial)) {
    const bool sure = guess.guessed.empty();
    fault.rule += fmt::format("; in dataset.json, {}, {}: {}", place(entry, layout),
                              sure ? "write" : "write, if it is right", written);
    if (!sure) fault.rule += fmt::format(" ({})", fmt::join(guess.guessed, "; "));
    return InputError(fault);
  }
  if (guess.asked.empty()) return error;
  fault.rule += fmt::format("; the columns are {}, and dataset.json must say {}", column_names_of(form),
                            fmt::join(guess.asked, "; and "));
  if (!written.empty()) fault.rule += fmt::format("; the rest is {}", written);
  return InputError(fault);
}

}  // namespace coilwright::formats
