#include "exports/chain/torque_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "coilwright/text/csv/csv_writer.hpp"

namespace coilwright::exports {
namespace {

constexpr double widest_step = 2.0 * std::numbers::pi / 180.0;
constexpr double linear_tolerance = 5e-4;  // of the largest torque
constexpr int most_steps = 480;

TorqueTable sampled(const actuator::HingePair& pair, int steps) {
  const magnetics::Curve& curve = *pair.torque_per_ampere;
  TorqueTable table{.joint = pair.joint, .coil = pair.coil};
  const double step = (curve.upper() - curve.lower()) / steps;
  for (int i = 0; i <= steps; ++i) {
    table.angles.push_back(i == steps ? curve.upper() : curve.lower() + i * step);
    table.torques.push_back(pair.sense * curve.value(table.angles.back()));
  }
  // The miss of a straight line is largest near its middle.
  for (std::size_t i = 0; i + 1 < table.angles.size(); ++i) {
    const double middle = pair.sense * curve.value(0.5 * (table.angles[i] + table.angles[i + 1]));
    table.linear_error =
        std::max(table.linear_error, std::abs(middle - 0.5 * (table.torques[i] + table.torques[i + 1])));
  }
  return table;
}

TorqueTable table_of(const actuator::HingePair& pair) {
  const magnetics::Curve& curve = *pair.torque_per_ampere;
  // A rational interpolant of the third degree needs four rows.
  int steps = std::max(4, static_cast<int>(std::ceil((curve.upper() - curve.lower()) / widest_step)));
  TorqueTable table = sampled(pair, steps);
  while (table.linear_error > linear_tolerance * largest_torque(table) && 2 * steps <= most_steps) {
    steps *= 2;
    table = sampled(pair, steps);
  }
  return table;
}

}  // namespace

std::vector<TorqueTable> torque_tables(const actuator::Model& model) {
  std::vector<TorqueTable> tables;
  for (const actuator::HingePair& pair : model.magnetics().hinge_pairs()) tables.push_back(table_of(pair));
  return tables;
}

double last_angle(int joint, const std::vector<TorqueTable>& tables) {
  double last = std::numbers::pi;
  for (const TorqueTable& table : tables)
    if (table.joint == joint) last = std::min(last, table.angles.back());
  return last;
}

double largest_torque(const TorqueTable& table) {
  double largest = 0.0;
  for (const double torque : table.torques) largest = std::max(largest, std::abs(torque));
  return largest;
}

std::string torque_csv(const std::vector<TorqueTable>& tables) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"joint", "coil", "angle_rad", "torque_Nm_A"});
  for (const TorqueTable& table : tables)
    for (std::size_t i = 0; i < table.angles.size(); ++i)
      csv.row({table.joint + 1, table.coil + 1, table.angles[i], table.torques[i]});
  return out.str();
}

}  // namespace coilwright::exports
