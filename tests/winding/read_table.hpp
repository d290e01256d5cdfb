#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace coilwright::winding {

/// Rows of numbers of a comma-separated file in tests/data; its first line names the columns and is skipped.
inline std::vector<std::vector<double>> read_table(const std::string& name) {
  std::ifstream file(std::filesystem::path(COILWRIGHT_TEST_DATA) / name);
  if (!file) throw std::runtime_error("cannot read tests/data/" + name);
  std::string line;
  std::getline(file, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::vector<double>& row = rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
  }
  return rows;
}

}  // namespace coilwright::winding
