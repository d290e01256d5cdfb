#pragma once

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
    std::vector<std::vector<double>> values;  ///< a value an objective; an even choice of them
  };
  std::vector<Group> groups;
};

/// From evaluations.csv: at most 3000 of each group are kept.
[[nodiscard]] OtherDesigns read_other_designs(const std::filesystem::path& folder, const FrontTable& front);

/// The scatter of two objectives (a third one as colour), configurations by shape, with the other designs behind; and
/// parallel coordinates of variables and objectives. The second has a data set
/// "selected", with the first design; in the first the script puts a mark over the selected one, so that many are not
/// drawn anew.
[[nodiscard]] std::vector<Figure> front_figures(const FrontTable& front, const OtherDesigns& others);

}  // namespace coilwright::page
