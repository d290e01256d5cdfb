#include "cli/parts/merge/parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "cli/outputs.hpp"
#include "cli/runs/part_run.hpp"
#include "cli/runs/run_files.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/text/input_error.hpp"

namespace coilwright::cli {
namespace {

namespace fs = std::filesystem;

text::InputError refused_part(const fs::path& folder, std::string rule) {
  return text::InputError({.file = folder.string(), .rule = std::move(rule)});
}

formats::PartFile part_in(const fs::path& folder) {
  const fs::path file = folder / part_name;
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file, error);
  if (!fs::status_known(status)) throw refused_part(folder, "cannot be looked at: " + error.message());
  if (!fs::exists(status))
    throw refused_part(folder, "holds no finished part (part.json is not there): make it again with --resume");
  if (!fs::is_regular_file(status))
    throw refused_part(file, "must be the file that the part wrote, no link, pipe or folder: make the part again");
  return formats::read_part(file);
}

// found.json has the digest of part.json without itself.
PartFolder part_folder(const fs::path& path, formats::PartFile part) {
  PartFolder out{.path = path, .files = part.files};
  std::erase_if(part.files, [](const formats::FileOfPart& file) { return file.name == formats::found_name; });
  out.part_sha256 = results::sha256(formats::to_json(part).text());
  return out;
}

// A file or folder, whatever its names are.
bool is_one_of(const fs::path& path, const std::vector<fs::path>& others) {
  return std::ranges::any_of(others, [&](const fs::path& other) {
    std::error_code none;  // one of the two is not there
    return fs::equivalent(path, other, none);
  });
}

// The folder of the result and those in which it lies.
std::vector<fs::path> folders_above(const fs::path& out) {
  std::vector<fs::path> all;
  std::error_code none;
  for (fs::path each = fs::weakly_canonical(fs::absolute(out), none); all.empty() || each != all.back();
       each = each.parent_path())
    all.push_back(each);
  return all;
}

// What is there under the names that merge writes or removes.
std::vector<fs::path> present_results(const fs::path& out) {
  std::vector<fs::path> all = run_files_in(out);
  std::erase_if(all, [](const fs::path& file) {
    std::error_code none;
    return !fs::exists(file, none);
  });
  return all;
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

std::vector<std::size_t> missing_of(const std::map<std::size_t, PartFolder>& found, std::size_t of) {
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
  std::map<std::size_t, PartFolder> found;
  Makers makers;
  const std::vector<fs::path> above = folders_above(options.out), present = present_results(options.out);
  for (const fs::path folder : options.parts) {
    if (is_one_of(folder, above))
      throw refused_part(folder, fmt::format("is a part, and the result must not come into it: take another folder "
                                             "than {} for that",
                                             printed(options.out)));
    const formats::PartFile part = part_in(folder);
    for (const formats::FileOfPart& file : part.files)
      if (!present.empty() && is_one_of(folder / file.name, present))
        throw refused_part(folder / file.name, fmt::format("is in {}, too, where the result is to come: take another "
                                                           "folder for that",
                                                           printed(options.out)));
    if (!first) first = part;
    require_of_one_run(part, folder, *first, options.parts.front());
    const auto [known, is_new] = found.try_emplace(part.part.number, part_folder(folder, part));
    if (!is_new)
      throw refused_part(folder, fmt::format("is part {} of {}, as {} is: name one of them", part.part.number,
                                             part.part.of, printed(known->second.path)));
    makers.add(part);
  }
  const std::size_t of = first.value().part.of;
  const std::vector<std::size_t> missing = missing_of(found, of);
  if (!missing.empty())
    throw refused_part(options.out, fmt::format("cannot be made: part{} {} of {} {} missing; make {} and merge again",
                                                missing.size() > 1 ? "s" : "", ranges_text(missing), of,
                                                missing.size() > 1 ? "are" : "is", missing.size() > 1 ? "them" : "it"));
  Parts parts{.whole = first->whole, .made_by = makers.texts()};
  for (auto& [number, folder] : found) parts.folders.push_back(std::move(folder));
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

void for_each_part(const Parts& parts, const std::function<void(std::size_t, const PartFolder&)>& take) {
  for (std::size_t i = 0; i < parts.folders.size(); ++i) {
    const PartFolder& part = parts.folders[i];
    for (const formats::FileOfPart& file : part.files) read_file_of(part, file.name, {});
    take(i + 1, part);
  }
}

void read_file_of(const PartFolder& part, std::string_view name, const std::function<void(std::string_view)>& take) {
  const auto file = std::ranges::find(part.files, name, &formats::FileOfPart::name);
  if (file == part.files.end() || !results::holds_exactly(part.path / name, file->bytes, file->sha256, take))
    throw refused_part(part.path / name, "is not there, or not what the part wrote (SHA-256): make the part again");
}

text::Document document_of(const PartFolder& part, std::string_view name) {
  std::string content;
  read_file_of(part, name, [&](std::string_view block) { content += block; });
  return text::parse_json(content, (part.path / name).string());
}

results::Provenance provenance_of_whole(const archive::Contents& whole) {
  results::Provenance out{.command = whole.command, .changes = whole.changes, .seed = whole.seed};
  for (const archive::Input& input : whole.inputs)
    out.inputs.push_back({.file = input.file, .sha256 = input.sha256, .text = input.text});
  return out;
}

}  // namespace coilwright::cli
