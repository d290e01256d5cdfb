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

}  // namespace coilwright::exports
