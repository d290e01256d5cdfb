#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "coilwright/page/page.hpp"
#include "coilwright/page/pages.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/sizing/study/study.hpp"
#include "coilwright/text/csv/csv_texts.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::page {

/// front.csv, or another table of designs, with what its columns are.
struct FrontTable {
  text::CsvTexts texts;
  std::vector<std::string> variables;
  std::vector<std::string> objectives;
  std::vector<bool> largest;  ///< of each objective: whether it is to be large
  std::vector<std::string> margins;
  std::vector<std::string> quantities;  ///< all others

  [[nodiscard]] std::size_t rows() const noexcept { return texts.rows(); }
};

/// Of the folder of a `pareto`; the objectives are those of its result.json.
[[nodiscard]] FrontTable read_front(const std::filesystem::path& folder, const text::Node& result);

/// Of the folder of a `sweep`: best.csv, the best designs of each configuration, likewise.
[[nodiscard]] FrontTable read_leaders(const std::filesystem::path& folder, const text::Node& result);

/// The columns that people look at: the objectives, then the variables that are none.
[[nodiscard]] std::vector<std::string> shown_columns(const FrontTable& front);

/// The fields of a row in some columns, to read: numbers with six digits, texts as they are.
[[nodiscard]] std::vector<std::string> shown_fields(const FrontTable& front, std::size_t row,
                                                    std::span<const std::string> columns);

/// A field of a CSV file as JSON: a number where it is one, null where it is empty, else a text.
[[nodiscard]] text::Json json_of(const std::string& field);

/// Texts as a JSON array.
[[nodiscard]] text::Json texts_json(const std::vector<std::string>& texts);

/// The point of the search space at which a study has the variables of a row; nothing where it has no such point.
[[nodiscard]] std::optional<std::vector<double>> point_of(const sizing::Study& study, const FrontTable& front,
                                                          std::size_t row);

/// At most `most` of `count` rows, evenly, with the first and the last.
[[nodiscard]] std::vector<std::size_t> even_choice(std::size_t count, std::size_t most);

/// The design of a row, evaluated anew; nothing where the study has no such design, or it comes out with other
/// objectives than its row has.
[[nodiscard]] std::optional<sizing::EvaluatedDesign> evaluated_row(const sizing::DesignProblem& problem,
                                                                   const FrontTable& front, std::size_t row);

/// What a front's designs look like and how they move, for those rows that are drawn, to be read by the page's script:
/// `rows`, `poses` (three sections a row), `times_s`, `angle_deg` (bending angle, a list a row). A design whose
/// objectives come out other than its row has them is left out and counted in `differ`.
[[nodiscard]] text::Json front_pictures(const sizing::Study& study, const FrontTable& front, std::size_t most);

/// Every design of a front as an actuator file: `lines` of the first one's text, the places of those that differ from
/// row to row (`places`), and of every row what stands there (`texts`); a row whose text has another number of lines
/// has it as a whole, in `whole` by its number.
[[nodiscard]] text::Json front_actuators(const sizing::Study& study, const FrontTable& front);

/// Evaluated designs that are not on the front, by the values of its objectives.
struct OtherDesigns {
  struct Group {
    std::string name;                         ///< of one: "breaks a limit", "beaten by the front"
    std::string said;                         ///< of several: "break a limit"
    std::size_t count{};                      ///< of all of them
    std::size_t outside{};                    ///< of those: outside of the axes
    std::vector<std::vector<double>> values;  ///< a value an objective; an even choice of them
  };
  std::vector<Group> groups;
  /// Of the first two objectives from where to where the designs of the front and all others that keep every limit
  /// reach, with some room. What breaks a limit may reach a hundred times as far, and would make a dot of the front:
  /// what of it is outside is counted and not drawn. Empty where no design keeps every limit.
  std::vector<std::array<double, 2>> axes;
};

/// From evaluations.csv of a result: at most 3000 of each group are kept.
[[nodiscard]] OtherDesigns read_other_designs(const std::filesystem::path& folder, const text::Node& result,
                                              const FrontTable& front);

/// The scatter of two objectives (a third one as colour), configurations by shape, with the other designs behind; and
/// parallel coordinates of variables and objectives. The second has a data set
/// "selected", with the first design; in the first the script puts a mark over the selected one, so that many are not
/// drawn anew.
[[nodiscard]] std::vector<Figure> front_figures(const FrontTable& front, const OtherDesigns& others);

}  // namespace coilwright::page
