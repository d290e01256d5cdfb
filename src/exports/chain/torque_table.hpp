#pragma once

#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::exports {

/// Torque per ampere of one coil and magnet over the angle of their joint, at even steps.
struct TorqueTable {
  int joint{};                    ///< index of the joint
  int coil{};                     ///< index of the coil whose current it takes
  std::vector<double> angles{};   ///< rad, increasing in even steps
  std::vector<double> torques{};  ///< N m/A, one per angle, opening positive
  double linear_error{};          ///< largest miss of straight lines between the rows, N m/A
};

/// One table for each pair of a coil and a magnet at a joint, over the range in which its torque is known. The steps
/// are halved from 2 degrees until straight lines between the rows miss by at most 5e-4 of the largest torque, or until
/// there would be more than 480 (MuJoCo takes 500 numbers a row of data).
[[nodiscard]] std::vector<TorqueTable> torque_tables(const actuator::Model& model);

/// Where the torque at a joint ceases to be known, rad: its tables end there. Half a turn where it has none.
[[nodiscard]] double last_angle(int joint, const std::vector<TorqueTable>& tables);

/// Largest torque per ampere of a table, N m/A.
[[nodiscard]] double largest_torque(const TorqueTable& table);

/// The tables as CSV: joint and coil counted from 1, angle_rad, torque_Nm_A.
[[nodiscard]] std::string torque_csv(const std::vector<TorqueTable>& tables);

}  // namespace coilwright::exports
