#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "coilwright/page/page.hpp"
#include "page/front_table.hpp"

namespace coilwright::page {

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
