#include "coilwright/results/provenance.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>
#include <system_error>

#include "coilwright/results/build_info.hpp"
#include "coilwright/results/sha256.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/object_reader.hpp"

namespace coilwright::results {
namespace {

constexpr std::size_t largest_input = 512'000'000;  // bytes, as of a record

text::Json json_of(const Provenance& provenance) {
  using text::Json;
  const Commit built = commit();
  const auto digests_of = [](const std::vector<InputRecord>& files) {
    return Json::list(files, [](const InputRecord& file) {
      return Json::object({{"file", file.file}, {"sha256", file.sha256}});
    });
  };
  Json out = Json::object({{"format", "provenance/1"},
                           {"program", "coilwright"},
                           {"version", version()},
                           {"commit", text::text_or_null(built.hash)},
                           {"changed_since_commit", built.hash.empty() ? Json(nullptr) : Json(built.changed)},
                           {"command", provenance.command},
                           {"inputs", digests_of(provenance.inputs)},
                           {"set", Json::list(provenance.changes)},
                           {"question_sha256", hash_of(provenance)},
                           {"seed", provenance.seed}});
  if (!provenance.starts.empty()) out.set("starts", digests_of(provenance.starts));
  return out;
}

// The text of an object behind its last member.
constexpr std::string_view end_of_object = "\n}\n";
constexpr std::string_view seal = ",\n  \"sha256\": ";

// The text of an object, up to there, with a last member that is the digest of what stands before it.
std::string sealed(std::string_view members) {
  return fmt::format("{}{}\"{}\"{}", members, seal, sha256(members), end_of_object);
}

bool is_sealed(std::string_view text) {
  const std::size_t at = text.rfind(seal);
  return at != std::string_view::npos && sealed(text.substr(0, at)) == text;
}

text::Node required_member(const text::Node& object, std::string_view key) {
  if (const auto found = object.find(key)) return *found;
  throw object.error_without_value(fmt::format("must have \"{}\" (docs/formats.md)", key));
}

}  // namespace

InputRecord record_of(const text::InputText& input) {
  return {.file = input.file, .sha256 = sha256(input.text), .text = input.text};
}

InputRecord record_of(const std::filesystem::path& file) {
  return record_of(text::read_text(file, largest_input));
}

std::string hash_of(const Provenance& provenance) {
  std::string text;
  for (const InputRecord& input : provenance.inputs) text += input.sha256 + '\n';
  for (const std::string& change : provenance.changes) text += change + '\n';
  return sha256(text);
}

void write_provenance(text::OutputFolder& folder, const Provenance& provenance) {
  text::Json out = json_of(provenance);
  out.set("files", text::Json::list(folder.written(), [](const auto& file) {
            return text::Json::object({{"file", file.first},
                                       {"bytes", std::filesystem::file_size(file.second)},
                                       {"sha256", sha256_of_file(file.second)}});
          }));
  const std::string text = out.text();
  folder.write(provenance_name, sealed(std::string_view(text).substr(0, text.size() - end_of_object.size())));
}

std::optional<Question> question_in(const std::filesystem::path& folder) {
  std::error_code none;
  if (!exists(symlink_status(folder / provenance_name, none))) return std::nullopt;
  const text::Document provenance = text::read_json(folder / provenance_name);
  const auto question = provenance.root().find("question_sha256"), seed = provenance.root().find("seed");
  if (!question || !seed) return std::nullopt;
  Question out{.sha256 = question->text()};
  if (!seed->is_null()) out.seed = seed->integer<std::uint64_t>();
  return out;
}

std::optional<InputsBehind> inputs_behind(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / provenance_name;
  std::error_code none;
  if (!is_regular_file(file, none)) return std::nullopt;
  const text::Document document = text::read_json(file);
  InputsBehind out;
  for (const text::Node& input : required_member(document.root(), "inputs").elements(text::Length::at_least(1))) {
    const std::filesystem::path named = out.files.emplace_back(required_member(input, "file").text());
    const std::string& digest = required_member(input, "sha256").text();
    if (out.changed.empty() && (!is_regular_file(named, none) || record_of(named).sha256 != digest))
      out.changed = named.string();
  }
  for (const text::Node& change : required_member(document.root(), "set").elements())
    out.changes.push_back(change.text());
  return out;
}

std::string why_unchecked(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / provenance_name;
  std::error_code none;
  const char* why = !exists(symlink_status(file, none))           ? "is not there"
                    : !text::read_json(file).root().find("files") ? "is by an earlier version, without digests"
                                                                  : nullptr;
  if (why == nullptr) return {};
  return fmt::format("{} {}: nothing tells whether these results are as they were written", file.string(), why);
}

void require_as_written(const std::filesystem::path& folder, std::span<const std::filesystem::path> present) {
  if (!why_unchecked(folder).empty()) return;
  const auto refuse = [](const std::filesystem::path& file) {
    throw text::InputError({.file = file.string(),
                            .rule =
                                "is not there, or not as the run of this folder wrote it (SHA-256 in provenance.json): "
                                "say its command again, with --force where it asks for that"});
  };
  const std::filesystem::path file = folder / provenance_name;
  const std::string text = text::read_text(file, text::json_size_limit).text;
  if (is_symlink(file) || !is_sealed(text)) refuse(file);
  const text::Document provenance = text::parse_json(text, file.string());
  std::set<std::string> named{provenance_name};
  for (const text::Node& each : provenance.root().find("files").value().elements()) {
    named.insert(text::read_object(each, [&](text::ObjectReader& in) {
      const std::string name = in.text("file");
      const auto bytes = in.integer<std::uintmax_t>("bytes", text::non_negative);
      if (!holds_exactly(folder / name, bytes, in.text("sha256"))) refuse(folder / name);
      return name;
    }));
  }
  for (const std::filesystem::path& each : present)
    if (!named.contains(each.filename().string())) refuse(each);
}

}  // namespace coilwright::results
