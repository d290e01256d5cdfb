#pragma once

#include <string>
#include <vector>

#include "coilwright/actuator/model/model.hpp"

namespace coilwright::exports {

/// A model of links, springs, dampers, stops and torque curves alone, and what had to go to make it one.
struct PlainModel {
  actuator::Model model;                ///< has_terms() is false; may have distant pairs
  std::vector<std::string> left_out{};  ///< one line each: what it was, and where it can be told how large it is
  std::string too_much{};               ///< as DistantForces has it
};

/// `model` without the effects that act while it runs and without a torque correction. Effects that change what is
/// fixed (a mass, a spring, a tilt, a curve) stay built in. Forces between parts that are not neighbours stay in the
/// result and are named among what is left out, because no format of links and joints has them.
[[nodiscard]] PlainModel plain_model(const actuator::Model& model);

/// What the forces between parts that are not neighbours do on the straight chain.
struct DistantForces {
  std::vector<std::string> lines{};  ///< one for magnets and one for coils with their largest torque; the last one says
                                     ///< where that is too much
  std::string too_much{};  ///< why a chain without them is of another actuator: they make more than a twentieth of what
                           ///< neighbours make at 1 A; empty where they do not
};
[[nodiscard]] DistantForces distant_forces(const actuator::Model& model);

/// That everything is at 20 degC, where the model is of a design, which knows its heat; empty for any other.
[[nodiscard]] std::vector<std::string> heat_of_a_design(const actuator::Model& model);
/// What its coils carry of one current, where that is not the whole each: links have a current for each.
[[nodiscard]] std::vector<std::string> shares_of_coils(const actuator::Model& model);

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
