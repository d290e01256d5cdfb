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

/// A number of a result with four digits, a text as it is, "-" for null.
[[nodiscard]] std::string cell_of(const text::Node& node);

/// The same of the member under `key`, which must be there.
[[nodiscard]] std::string cell_of(const text::Node& object, std::string_view key);

/// "mass_g <= 70" of a constraint with `quantity` and `at_most` or `at_least`.
[[nodiscard]] std::string limit_text(const text::Node& constraint);

/// Its margin in per cent of the limit's magnitude or, for a limit of 0, of an ordinary magnitude of its quantity;
/// negative where it is broken.
[[nodiscard]] double margin_percent(const text::Node& constraint);

/// "gap_mm 0.6, turns_radial 13": the members of an object of plain values.
[[nodiscard]] std::string members_text(const text::Node& object);

/// The same of an object of one, as "name value".
[[nodiscard]] std::string only_member_text(const text::Node& object);

/// "dry_friction and back_emf": the texts of a list; "none" of an empty one.
[[nodiscard]] std::string ids_text(const text::Node& list);

/// Whether a limit of a part (`part_limits` or `broken_part_limits` of a result) is one that the part stands more than
/// under a condition; false in results of before there were such.
[[nodiscard]] bool is_conditional(const text::Node& limit);

/// Whether the search or the sweep of a result was interrupted, and what to say of it.
[[nodiscard]] bool was_interrupted(const text::Node& result);
inline constexpr const char* interrupted_caution =
    "INTERRUPTED: the run may find better designs, and did not look at all that an answer rests on; --resume goes on.";

/// What a reader must know beside an answer of several designs: INTERRUPTED, "BEWARE: ..." of the limits of parts that
/// designs break as their study does not set them (`broken_part_limits` of a result), and "MIND: ..." of conditional
/// ones, below a sentence that names the designs; empty where all keep all.
[[nodiscard]] std::vector<std::string> cautions_of_parts(const text::Node& result);

/// Whether the design of a result of `size` keeps every limit.
[[nodiscard]] bool is_feasible(const text::Node& result);

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

/// " The search ended because .." as the terminal has it, of one objective or, `of_front`, of several; empty of results
/// that do not say by how much the last designs bettered what was found.
[[nodiscard]] std::string end_of_search(const text::Node& result, bool of_front);

/// The files that the result was made of, as provenance.json names them, each with the first digits of its SHA-256.
[[nodiscard]] std::vector<std::string> input_lines(const std::filesystem::path& folder);

/// The texts of the list under `key`.
[[nodiscard]] std::vector<std::string> texts_of(const text::Node& object, std::string_view key);

}  // namespace coilwright::page
