#include "coilwright/formats/simulation/motion_table.hpp"

#include <fmt/format.h>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/angle.hpp"

namespace coilwright::formats {

using simulation::CommandedInput;
using simulation::Drive;
using simulation::RecordedMotion;

std::vector<std::string> columns_of_input(const CommandedInput& command) {
  const bool common = command.addressing == simulation::Addressing::common;
  if (command.drive == Drive::voltage) return {"voltage_V"};
  if (command.drive == Drive::current && common) return {"current_A"};
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= command.rows.front().size(); ++i)
    names.push_back(command.drive == Drive::current ? fmt::format("current{}_A", i) : fmt::format("torque{}_Nm", i));
  return names;
}

std::vector<std::string> columns_of_motion(const CommandedInput& command, int joints) {
  std::vector<std::string> columns{"time_s"};
  const std::vector<std::string> commanded = columns_of_input(command);
  columns.insert(columns.end(), commanded.begin(), commanded.end());
  for (int j = 1; j <= joints; ++j) columns.push_back(fmt::format("theta{}_deg", j));
  columns.insert(columns.end(), {"bending_angle_deg", "bending_speed_deg_s"});
  return columns;
}

std::vector<double> motion_row(const CommandedInput& command, const RecordedMotion& motion, std::size_t sample) {
  const simulation::State& state = motion.states[sample];
  std::vector<double> row{command.times[sample]};
  row.insert(row.end(), command.rows[sample].begin(), command.rows[sample].end());
  for (const double angle : state.angles) row.push_back(angle * units::degrees_per_radian);
  row.push_back(motion.bending_angles[sample] * units::degrees_per_radian);
  row.push_back(state.rates.sum() * units::degrees_per_radian);
  return row;
}

void write_motion(std::ostream& out, const CommandedInput& command, const RecordedMotion& motion) {
  const int joints = static_cast<int>(motion.states.front().angles.size());
  text::CsvWriter csv(out, columns_of_motion(command, joints));
  for (std::size_t i = 0; i < motion.states.size(); ++i) csv.row(motion_row(command, motion, i));
}

}  // namespace coilwright::formats
