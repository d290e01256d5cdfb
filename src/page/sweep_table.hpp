#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "page/front.hpp"

namespace coilwright::page {

/// What designs.csv of a sweep says as a whole: it is read once, row by row, and may be of any length.
struct SweepTable {
  /// The best feasible value of each objective over the values of one variable.
  struct Best {
    std::string group;                                  ///< configuration of the designs; empty where none varies
    std::map<std::string, std::vector<double>> rows{};  ///< by the variable's value as it is written, an objective each
  };
  /// A design that stands for many: its values, in the order of the names.
  struct Sample {
    bool keeps_limits{};
    std::vector<std::string> variables;
    std::vector<std::optional<double>> objectives;
  };
  /// What two variables do together: `across` stands before `up` among the variables.
  struct Map {
    std::size_t across{};
    std::size_t up{};
    /// By the places of the two values among `values`: the best feasible value of each objective, or nothing where no
    /// design there keeps every limit. No cells at all: there are more than 2500.
    std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> cells{};
  };
  /// How often a limit is broken.
  struct Broken {
    std::string margin;  ///< name of its column
    std::size_t times{};
    std::size_t alone{};  ///< of those: no other limit is
  };

  std::vector<std::string> variables;
  std::vector<std::vector<Best>> best;           ///< of each variable, a list a configuration
  std::vector<Sample> samples;                   ///< at most some 3000, at random; equal from call to call
  std::vector<std::vector<std::string>> values;  ///< of each variable, as they come; some, of one with very many
  std::vector<Map> maps;                         ///< of a grid, for any two variables that have more than one value
  std::vector<Broken> broken;                    ///< of each limit
  std::map<std::string, std::size_t> failures;   ///< designs by why they could not be evaluated
  std::size_t rows{};
  bool sampled{};  ///< whether the designs are a sample and no grid
};

/// Of the folder of a `sweep`; `leaders` are its best designs, `designs` how many rows there are.
[[nodiscard]] SweepTable read_sweep(const std::filesystem::path& folder, const FrontTable& leaders, std::size_t designs,
                                    bool sampled);

/// A map of two variables with an objective as colour, all three for the reader to choose: of a grid its cells, of a
/// sample, and of a grid too fine for cells, its designs. Nothing where fewer than two variables take more than one
/// value.
[[nodiscard]] std::optional<Section> map_section(const SweepTable& table, const FrontTable& leaders);

}  // namespace coilwright::page
