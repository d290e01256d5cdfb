// Tables of torque over angle as `coilwright export` writes them, for programs that know nothing of Coilwright.
#pragma once

#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// Straight lines between the rows, and on beyond the last.
struct Table {
  std::vector<double> angles, torques;
  [[nodiscard]] double at(double angle) const {
    std::size_t i = 1;
    while (i + 1 < angles.size() && angles[i] < angle) ++i;
    const double share = (angle - angles[i - 1]) / (angles[i] - angles[i - 1]);
    return torques[i - 1] + share * (torques[i] - torques[i - 1]);
  }
};

// Without the line of headings; an empty cell is 0.
inline std::vector<std::vector<double>> rows_of(const char* file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    std::vector<double> row;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell.empty() ? 0.0 : std::stod(cell));
    rows.push_back(row);
  }
  return rows;
}

// By the number of the joint, from 1; each joint has one coil.
using Tables = std::map<int, Table>;

// Of torque.csv.
inline Tables tables_of(const char* file) {
  Tables out;
  for (const std::vector<double>& row : rows_of(file)) {
    Table& table = out[static_cast<int>(row[0])];
    table.angles.push_back(row[2]);
    table.torques.push_back(row[3]);
  }
  return out;
}
