#include "coilwright/simulation/pressed_joints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coilwright::simulation {

std::vector<int> pressed_joints(const actuator::Model& model, const mechanics::JointVector& angles) {
  std::vector<int> out;
  for (int j = 0; j < model.joints(); ++j)
    if (model.hinges()[j].contact.torque(angles[j], 0.0) > 0.0) out.push_back(j);
  return out;
}

std::string joints_text(std::span<const int> joints) {
  std::vector<int> numbers;
  for (const int joint : joints) numbers.push_back(joint + 1);
  if (numbers.size() == 1) return fmt::format("joint {}", numbers.front());
  const std::span<const int> all(numbers);
  return fmt::format("joints {} and {}", fmt::join(all.first(all.size() - 1), ", "), all.back());
}

std::string pressed_joints_text(std::span<const int> at_rest, std::span<const int> under_current) {
  const auto verb = [](std::span<const int> joints) { return joints.size() == 1 ? "is" : "are"; };
  const auto pronoun = [](std::span<const int> joints) { return joints.size() == 1 ? "it does" : "they do"; };
  if (under_current.empty())
    return at_rest.empty() ? std::string()
                           : fmt::format("magnets or weight hold {} shut without current", joints_text(at_rest));
  const std::string text =
      fmt::format("{} {} pressed shut at this current", joints_text(under_current), verb(under_current));
  if (std::ranges::equal(at_rest, under_current))
    return text + fmt::format(", as without it: {} not bend", pronoun(under_current));
  return at_rest.empty() ? text + fmt::format(": {} not open", pronoun(under_current))
                         : text + fmt::format(", {} without current", joints_text(at_rest));
}

}  // namespace coilwright::simulation
