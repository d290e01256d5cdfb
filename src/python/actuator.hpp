#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/model/effect_catalogue.hpp"
#include "coilwright/actuator/model/model.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"

namespace coilwright::python {

/// An actuator as Python holds it: immutable, with the name that errors about it carry.
struct Actuator {
  formats::ActuatorFile content;
  std::string text;    ///< of its file, complete
  std::string origin;  ///< "finger.json"; "actuator" of one made in memory

  [[nodiscard]] bool is_design() const { return std::holds_alternative<actuator::Design>(content.content); }
  struct Driven {
    actuator::Model model;
    std::optional<actuator::CoilElectrics> coil{};  ///< of a design
    std::optional<double> supply_drives{};          ///< A, coils at 20 degC, where its operating point has a voltage
  };
  /// The model, or that of the design with its coil. Throws InputError where it cannot be built.
  [[nodiscard]] Driven driven() const;
};

/// The actuator of a file's text; its effects are of `effects`. Throws InputError.
[[nodiscard]] Actuator actuator_of(std::string text, std::string origin, const actuator::EffectCatalogue& effects);

/// A design that something found.
[[nodiscard]] Actuator actuator_of(const actuator::Design& design, const std::string& name,
                                   const std::optional<actuator::OperatingPoint>& point);

}  // namespace coilwright::python
