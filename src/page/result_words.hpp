#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/page/page.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// What pages call the models of a diagnosis, by their keys in diagnosis.json, which are columns of residuals.csv: the
/// words of summary.txt.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 4> model_words = {
    {{"declared", "as declared"}, {"before", "fitted anew"}, {"after", "with effects"}, {"corrected", "corrected"}}};

/// The value under `key` of an object of a result. Throws text::InputError that names the key where it is not there.
[[nodiscard]] text::Node member_of(const text::Node& object, std::string_view key);

/// The one member of an object that has one, as {"maximise": "mass_g"}. Throws text::InputError where it has another
/// number of them.
[[nodiscard]] text::Node only_member_of(const text::Node& object);

/// A number of a result with six digits, a text as it is, "-" for null.
[[nodiscard]] std::string cell_of(const text::Node& node);

/// The same of the member under `key`, which must be there.
[[nodiscard]] std::string cell_of(const text::Node& object, std::string_view key);

/// "dry_friction and back_emf": the texts of a list; "none" of an empty one.
[[nodiscard]] std::string ids_text(const text::Node& list);

/// An objective of a result, and which way it improves.
struct Objective {
  std::string name;
  bool largest{};  ///< whether it is to be as large as possible
};
/// Those of a result. Throws text::InputError where it has another number of them.
[[nodiscard]] std::vector<Objective> objectives_of(const text::Node& result, text::Length count);
/// The one of a result of `size`.
[[nodiscard]] Objective objective_of(const text::Node& result);

/// What provenance.json tells of where a result is from, as one line.
[[nodiscard]] std::string origin_text(const std::filesystem::path& folder, std::string_view made_by);

/// All columns of a table beside a result.
[[nodiscard]] text::CsvTexts read_table(const std::filesystem::path& file);

/// Throws text::InputError where a table beside a result does not have as many rows as the result counts: it was cut,
/// or is of another run.
void require_rows(const text::CsvTexts& table, std::size_t counted);

/// Designs that the search of a result has evaluated.
[[nodiscard]] std::size_t evaluations_of(const text::Node& result);

/// The files that the result was made of, as provenance.json names them, each with the first digits of its SHA-256.
[[nodiscard]] std::vector<std::string> input_lines(const std::filesystem::path& folder);

}  // namespace coilwright::page
