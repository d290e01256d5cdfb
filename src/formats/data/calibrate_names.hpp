#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/lumped_model.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/formats/data/declared_actuator.hpp"
#include "coilwright/measurement/replay/calibration_target.hpp"
#include "coilwright/text/input_error.hpp"
#include "coilwright/text/json/document.hpp"
#include "coilwright/text/rule.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

/// A name in a data set, and its place there.
struct CalibrateName {
  std::string name;
  std::string place;      ///< JSON pointer
  bool is_value = false;  ///< whether the name stands there as a text, and not as a key
};

/// The names of one data set, gone through from the first to the last.
class CalibrateNames {
 public:
  /// `dataset` is the file in which they stand, `actuator` the one in which pointers lead.
  CalibrateNames(std::vector<CalibrateName> names, std::string dataset, std::string actuator)
      : names_(std::move(names)), dataset_(std::move(dataset)), actuator_(std::move(actuator)) {}

  [[nodiscard]] std::size_t size() const { return names_.size(); }
  [[nodiscard]] const std::string& name(std::size_t i) const { return names_[i].name; }
  /// Throws when it is no JSON pointer.
  [[nodiscard]] std::vector<std::string> steps(std::size_t i) const;

  /// Says that name `i` stands for these numbers of the file. Throws when one of them has been claimed before.
  void claim(std::size_t i, const std::vector<std::string>& pointers);

  [[nodiscard]] text::InputError error(std::size_t i, const std::string& rule) const;
  [[nodiscard]] text::InputError leads_nowhere(std::size_t i) const;
  /// `why` ends "must lead to a number that a fit can move: ".
  [[nodiscard]] text::InputError cannot_move(std::size_t i, const std::string& why) const;

  /// The number of an effect that `steps` lead to, by four steps (/effects/0/parameters/torque_Nmm); nothing where they
  /// do not lead into "effects". Throws where they lead there and to nothing that can be calibrated.
  [[nodiscard]] std::optional<measurement::replay::EffectNumber> effect_number(
      std::size_t i, std::span<const std::string> steps, const std::vector<actuator::Effect>& effects) const;

 private:
  std::vector<CalibrateName> names_;
  std::string dataset_;
  std::string actuator_;
  std::map<std::string, std::size_t> claimed_{};  // number to the place of its name
};

/// A parameter of that name and value (SI), with the bounds of `rule` in the unit of `key`. `usual` is a change of it
/// that is usual where it is 0, SI; > 0.
[[nodiscard]] measurement::replay::CalibrationParameter calibration_parameter(std::string name, std::string_view key,
                                                                              double declared, const text::Rule& rule,
                                                                              double usual);

/// The same for a number of an effect that the file declares.
[[nodiscard]] measurement::replay::CalibrationParameter calibration_parameter(const std::string& pointer,
                                                                              const actuator::Effect& effect,
                                                                              std::size_t parameter);

using DesignNumber = measurement::replay::CalibratableNumber<measurement::replay::DesignTarget>;

/// The numbers of `design` that `names` mean, in their order; `document` is its file and `spec` its nominal model.
/// Throws InputError at a name that means no number or one that no fit can move.
[[nodiscard]] std::vector<DesignNumber> design_numbers(const text::Document& document, const actuator::Design& design,
                                                       const actuator::ModelSpec& spec, CalibrateNames& names);

/// Where a number of a lumped model stands in its file.
struct NumberInFile {
  std::string pointer;
  units::Unit unit;
  measurement::replay::LumpedNumber number;
};

/// The numbers of a lumped model that may be calibrated.
struct LumpedNumbers {
  std::vector<measurement::replay::CalibratableNumber<measurement::replay::LumpedTarget>> numbers{};
  std::vector<NumberInFile> in_file{};  ///< all that they set, but for numbers of effects
};

/// The numbers of `model` that `names` mean, in their order; `document` is its file. Throws InputError at a name that
/// means no number or one that no fit can move.
[[nodiscard]] LumpedNumbers lumped_numbers(const text::Document& document, const actuator::LumpedModel& model,
                                           CalibrateNames& names);

/// `document` with those numbers as they are in `model`.
[[nodiscard]] text::Document with_numbers_of(const text::Document& document, const std::vector<NumberInFile>& in_file,
                                             actuator::LumpedModel model);

}  // namespace coilwright::formats
