#include "cli/outputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <array>
#include <fstream>
#include <system_error>
#include "coilwright/text/one_line.hpp"
#include "coilwright/text/opened_file.hpp"
#include "coilwright/text/output/output_file.hpp"

#include "cli/options.hpp"
#include "coilwright/results/provenance.hpp"

namespace coilwright::cli {

void keep_inputs(const std::vector<std::filesystem::path>& inputs, const std::vector<std::filesystem::path>& outputs) {
  for (const std::filesystem::path& output : outputs) {
    for (const std::filesystem::path& input : inputs) {
      std::error_code none;  // one of the two is not there: then they are not the same
      if (std::filesystem::equivalent(input, output, none))
        throw text::OutputError(output, "it is an input of this command", text::OutputError::Stage::preparing);
    }
    std::error_code none;  // what is not there is its folder's matter
    if (exists(symlink_status(output, none))) const text::OutputFile trial(output);
  }
}

void require_writable(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files)
    if (!file.empty()) const text::OutputFile trial(file);
}

void add_force_option(CLI::App& command, bool& force) {
  add_flag(command, "--force", force, "Replace files of another kind or content, too");
}

text::OutputError other_content(const std::filesystem::path& file) {
  return {file, "it holds something else; --force replaces it, another --out keeps it",
          text::OutputError::Stage::preparing};
}

void keep_others(text::OutputFolder& folder, bool force) {
  folder.lock();  // until it is committed, so that what is found is what is replaced
  if (force) return;
  if (const auto file = folder.first_change()) throw other_content(*file);
}

void keep_other(text::OutputFile& file, bool force) {
  if (!force && file.would_change()) throw other_content(file.path());
}

void keep_other_kind(text::OutputFile& file, std::string_view mark, bool force) {
  if (!force && file.would_replace_other_kind(mark)) throw other_content(file.path());
}

void write_file(const std::filesystem::path& path, std::string_view mark, bool force,
                const std::function<void(std::ostream&)>& write) {
  text::OutputFile file(path);
  write(file.stream());
  keep_other_kind(file, mark, force);
  file.commit();
}

void keep_other_table(const text::OutputFile& file, std::span<const std::string> columns, bool force) {
  if (file.path() == "-") return;  // standard output, and no file of that name
  if (force || !exists(file.path())) return;
  std::ifstream present = text::opened(file.path());
  std::string header;
  if (!std::getline(present, header) || header == fmt::format("{}", fmt::join(columns, ","))) return;
  throw other_content(file.path());
}

bool has_mark(const std::filesystem::path& file, std::string_view mark) {
  std::error_code none;
  if (!is_regular_file(file, none)) return false;  // a pipe may never end
  std::string beginning(300, ' ');
  std::ifstream(file).read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return beginning.find(mark) != std::string::npos;
}

void keep_other_provenance(const std::filesystem::path& folder, bool force) {
  const std::filesystem::path file = folder / results::provenance_name;
  std::error_code none;
  if (!force && exists(symlink_status(file, none)) && !has_mark(file, "\"provenance/1\"")) throw other_content(file);
}

std::string printed(const std::filesystem::path& path) {
  const std::string plain = path.string();
  return text::one_line(plain, 4 * plain.size());  // an escape of one byte is four long
}

void add_written_json_option(CLI::App& command, bool& json) {
  add_flag(command, "--json", json, "Print what was written as JSON");
}

text::Json written_json(const std::vector<std::filesystem::path>& files) {
  return text::Json::object({{"files", text::Json::list(files, [](const auto& each) { return each.string(); })}});
}

void require_file_for_json(bool json, const std::string& out) {
  if (json && out == "-")
    throw CLI::ValidationError("--json", "needs a file for --out: standard output has the result itself");
}

}  // namespace coilwright::cli
