#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::testing {

/// An effect that has a name, perhaps numbers and a way to check it, and nothing else: enough for a report.
class NamedEffect final : public actuator::EffectKind {
 public:
  NamedEffect(std::string id, std::string description, std::vector<actuator::EffectParameter> parameters = {},
              std::string check = {})
      : id_(std::move(id)),
        description_(std::move(description)),
        parameters_(std::move(parameters)),
        check_(std::move(check)) {}
  [[nodiscard]] std::string_view id() const override { return id_; }
  [[nodiscard]] actuator::Stage stage() const override { return actuator::Stage::hinge; }
  [[nodiscard]] std::string_view description() const override { return description_; }
  [[nodiscard]] std::string_view equation() const override { return ""; }
  [[nodiscard]] std::string_view source() const override { return ""; }
  [[nodiscard]] std::string_view check() const override { return check_; }
  [[nodiscard]] std::span<const actuator::EffectParameter> parameters() const override { return parameters_; }
  [[nodiscard]] std::vector<std::vector<double>> starts(const actuator::RigScale&) const override { return {{}}; }
  [[nodiscard]] std::unique_ptr<const actuator::EffectTerm> build(std::span<const double>,
                                                                  actuator::ModelSpec&) const override {
    return nullptr;
  }

 private:
  std::string id_;
  std::string description_;
  std::vector<actuator::EffectParameter> parameters_;
  std::string check_;
};

}  // namespace coilwright::testing
