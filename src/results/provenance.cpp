#include "coilwright/results/provenance.hpp"

#include "coilwright/results/build_info.hpp"
#include "coilwright/results/sha256.hpp"

namespace coilwright::results {
namespace {

constexpr std::size_t largest_input = 512'000'000;  // bytes, as of a record

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

text::Json to_json(const Provenance& provenance) {
  using text::Json;
  const Commit built = commit();
  Json inputs = Json::list(provenance.inputs, [](const InputRecord& input) {
    return Json::object({{"file", input.file}, {"sha256", input.sha256}});
  });
  return Json::object({{"format", "provenance/1"},
                       {"program", "coilwright"},
                       {"version", version()},
                       {"commit", text::text_or_null(built.hash)},
                       {"changed_since_commit", built.hash.empty() ? Json(nullptr) : Json(built.changed)},
                       {"command", provenance.command},
                       {"inputs", std::move(inputs)},
                       {"set", Json::list(provenance.changes)},
                       {"question_sha256", hash_of(provenance)},
                       {"seed", provenance.seed}});
}

}  // namespace coilwright::results
