#include "parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <stdexcept>

#include "cli/outputs.hpp"
#include "cli/part_run.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;

text::InputError refused_part(const fs::path& folder, std::string rule) {
  return text::InputError({.file = folder.string(), .rule = std::move(rule)});
}

formats::PartFile part_in(const fs::path& folder) {
  std::error_code error;
  const bool is_there = fs::exists(folder / part_name, error);
  if (error) throw refused_part(folder, "cannot be looked at: " + error.message());
  if (!is_there)
    throw refused_part(folder, "holds no finished part (part.json is not there): make it again with --resume");
  return formats::read_part(folder / part_name).file;
}

// Which parts have which figures, and where they were made.
class Makers {
 public:
  void add(const formats::PartFile& part) {
    auto& [numbers, machine] = by_figures_[part.machine.figures];
    numbers.push_back(part.part.number);
    if (machine.empty()) machine = part.machine.name();
  }
  [[nodiscard]] std::map<std::string, std::string> texts() const {
    std::map<std::string, std::string> out;
    for (const auto& [figures, made] : by_figures_)
      out[figures] = fmt::format("{} on {}", ranges_text(made.first), made.second);
    return out;
  }

 private:
  std::map<std::string, std::pair<std::vector<std::size_t>, std::string>> by_figures_;
};

std::vector<std::size_t> missing_of(const std::map<std::size_t, fs::path>& found, std::size_t of) {
  std::vector<std::size_t> missing;
  for (std::size_t number = 1; number <= of; ++number)
    if (!found.contains(number)) missing.push_back(number);
  return missing;
}

void require_of_one_run(const formats::PartFile& part, const fs::path& folder, const formats::PartFile& first,
                        const fs::path& first_folder) {
  std::vector<std::string> differing = archive::differences(part.whole, first.whole);
  if (part.part.of != first.part.of)
    differing.push_back(fmt::format("of {} parts, not {}", part.part.of, first.part.of));
  if (!differing.empty())
    throw refused_part(folder, fmt::format("is a part of another run than {} ({}): merge each run by itself",
                                           printed(first_folder), fmt::join(differing, "; ")));
}

}  // namespace

std::string ranges_text(const std::vector<std::size_t>& ascending) {
  std::vector<std::string> ranges;
  for (std::size_t i = 0, last = 0; i < ascending.size(); i = last + 1) {
    for (last = i; last + 1 < ascending.size() && ascending[last + 1] == ascending[last] + 1;) ++last;
    ranges.push_back(last == i ? fmt::format("{}", ascending[i])
                               : fmt::format("{} to {}", ascending[i], ascending[last]));
  }
  return fmt::format("{}", fmt::join(ranges, ", "));
}

Parts parts_of(const MergeOptions& options) {
  std::optional<formats::PartFile> first;
  std::map<std::size_t, fs::path> found;
  Makers makers;
  for (const fs::path folder : options.parts) {
    const formats::PartFile part = part_in(folder);
    if (!first) first = part;
    require_of_one_run(part, folder, *first, options.parts.front());
    const auto [known, is_new] = found.try_emplace(part.part.number, folder);
    if (!is_new)
      throw refused_part(folder, fmt::format("is part {} of {}, as {} is: name one of them", part.part.number,
                                             part.part.of, printed(known->second)));
    makers.add(part);
  }
  const std::size_t of = first.value().part.of;
  const std::vector<std::size_t> missing = missing_of(found, of);
  if (!missing.empty())
    throw refused_part(options.out, fmt::format("cannot be made: part{} {} of {} {} missing; make {} and merge again",
                                                missing.size() > 1 ? "s" : "", ranges_text(missing), of,
                                                missing.size() > 1 ? "are" : "is", missing.size() > 1 ? "them" : "it"));
  Parts parts{.whole = first->whole, .made_by = makers.texts()};
  for (const auto& [number, folder] : found) parts.folders.push_back(folder);
  return parts;
}

void require_figures_of_parts(const Parts& parts, const formats::Machine& here) {
  std::vector<std::string> others;
  for (const auto& [figures, made] : parts.made_by)
    if (figures != here.figures) others.push_back("parts " + made);
  if (!others.empty())
    throw std::runtime_error(
        fmt::format("three designs have other numbers on {} ({}): results of different "
                    "processors must not be mixed; make these parts on processors of one kind",
                    here.name(), fmt::join(others, "; ")));
}

void for_each_part(const Parts& parts,
                   const std::function<void(std::size_t, const fs::path&, const text::Node&)>& take) {
  for (std::size_t i = 0; i < parts.folders.size(); ++i) {
    const formats::ReadPart part = formats::read_part(parts.folders[i] / part_name);
    take(i + 1, parts.folders[i], part.results());
  }
}

void require_written(const fs::path& file, const std::string& sha256) {
  std::error_code error;
  if (fs::is_regular_file(file, error) && results::sha256_of_file(file) == sha256) return;  // a pipe would never end
  throw refused_part(file, "is not there, or not what the part wrote (SHA-256): make the part again");
}

results::Provenance provenance_of_whole(const archive::Contents& whole) {
  results::Provenance out{.command = whole.command, .changes = whole.changes, .seed = whole.seed};
  for (const archive::Input& input : whole.inputs)
    out.inputs.push_back({.file = input.file, .sha256 = input.sha256, .text = input.text});
  return out;
}

}  // namespace coilwright::cli
