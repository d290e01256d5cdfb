#include "coilwright/text/json/json_pointer.hpp"

#include "coilwright/text/number.hpp"

namespace coilwright::text {

std::string pointer_step(std::string_view token) {
  std::string step = "/";
  for (const char c : token) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return step;
}

std::optional<std::vector<std::string>> pointer_steps(std::string_view pointer) {
  std::vector<std::string> steps;
  if (pointer.empty()) return steps;
  if (pointer.front() != '/') return std::nullopt;
  for (std::size_t i = 0; i < pointer.size(); ++i) {
    const char c = pointer[i];
    if (c == '/') {
      steps.emplace_back();
    } else if (c == '~') {
      const char escaped = i + 1 < pointer.size() ? pointer[++i] : '\0';
      if (escaped != '0' && escaped != '1') return std::nullopt;
      steps.back() += escaped == '0' ? '~' : '/';
    } else {
      steps.back() += c;
    }
  }
  return steps;
}

std::optional<std::size_t> array_index(std::string_view step) {
  if (step.empty() || (step.size() > 1 && step.front() == '0')) return std::nullopt;
  return number_in<std::size_t>(step);
}

std::optional<Node> follow(Node node, std::span<const std::string> steps) {
  for (const std::string& step : steps) {
    if (node.kind() == Node::Kind::array) {
      const std::vector<Node> elements = node.elements();
      const auto index = array_index(step);
      if (!index || *index >= elements.size()) return std::nullopt;
      node = elements[*index];
    } else if (node.kind() == Node::Kind::object) {
      const auto next = node.find(step);
      if (!next) return std::nullopt;
      node = *next;
    } else {
      return std::nullopt;
    }
  }
  return node;
}

}  // namespace coilwright::text
