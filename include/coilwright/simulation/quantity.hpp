#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/simulation/performance.hpp"
#include "coilwright/simulation/shared_result.hpp"

namespace coilwright::simulation {

/// Numbers outside the design that a study varies, in SI, by the name of the variable: "gripper_spacing_mm".
using Settings = std::map<std::string, double, std::less<>>;

/// A design at an operating point with all its results. Refers to values that must outlive it.
struct DesignView {
  const actuator::Design& design;
  const actuator::Assembly& assembly;
  const OperatingPoint& point;
  const Performance& performance;
  const Settings* settings = nullptr;  ///< settings that a study varies; nullptr: none
  SharedResults* shared = nullptr;     ///< results that several quantities share; nullptr: not kept
};

/// The settings of a design; empty if its study varies none.
[[nodiscard]] inline const Settings& settings_of(const DesignView& design) {
  static const Settings none;
  return design.settings == nullptr ? none : *design.settings;
}

/// Why a quantity has no value in one design.
struct NoValue {
  std::string reason;          ///< the reason, as the end of a sentence
  double infeasibility = 1.0;  ///< distance of the design from having a value, in any measure of order 1; > 0
};

/// One number of a design, as results print it and as a study may ask for it.
struct ResultQuantity {
  /// Returns the value in the unit of the name; absent if the quantity does not exist (a temperature in a thermal
  /// runaway). Pure, and called from several threads at once.
  using Value = std::function<std::optional<double>(const DesignView&)>;
  /// Returns the value for a lumped model; current in A.
  using LumpedValue = std::function<std::optional<double>(const MotionSummary& motion, double current)>;

  std::string name;               ///< ends with its unit: "mass_g"; without one it is a plain number
  std::string meaning;            ///< one line for a person
  double scale{};                 ///< an ordinary magnitude, in its unit, > 0, as a scale for differences
  Value value;                    ///< never empty
  std::string absence{};          ///< why it may have no value, as the end of a sentence; empty if it always has one
  LumpedValue value_of_lumped{};  ///< empty for a quantity that needs a design
  std::string unit{};             ///< the unit at the end of `name` where units::all_units() lacks it: "N_g"
  /// The pose to which the figure belongs, under current. Absent for quantities without a pose (mass) and for those of
  /// whichever poses the operating point is held in (thermal_load).
  std::optional<actuator::HeldCases> pose{};
  /// Explains why the quantity has no value in a design, if the reason differs between designs. Empty: it is always
  /// `absence`.
  std::function<NoValue(const DesignView&)> why_absent{};
  /// Whether the quantity describes something that lasts (heat, lost magnetisation) or whether a build can be driven at
  /// all. A build is then judged by the worst of its uses, otherwise by one use.
  bool in_every_use{};
};

/// Returns the quantity as one that is judged by the worst of all uses.
[[nodiscard]] inline ResultQuantity of_every_use(ResultQuantity quantity) {
  quantity.in_every_use = true;
  return quantity;
}

/// The poses of both arguments together; absent if neither has one.
[[nodiscard]] std::optional<actuator::HeldCases> either(std::optional<actuator::HeldCases> one,
                                                        std::optional<actuator::HeldCases> other);

/// Throws std::invalid_argument naming the quantity and the rule that it breaks: an empty name or meaning, a scale that
/// is not finite and > 0, an empty `value`.
void validate_quantity(const ResultQuantity& quantity);

/// Quantities in the order in which results print them, with unique names. An immutable value; copies are cheap and
/// share their rows.
class QuantityTable {
 public:
  /// Makes the table. Throws std::invalid_argument as `validate_quantity`, and for a name that occurs twice.
  explicit QuantityTable(std::vector<ResultQuantity> rows);
  // Copies only: a moved-from table would have no rows.
  QuantityTable(const QuantityTable&) = default;
  QuantityTable& operator=(const QuantityTable&) = default;
  ~QuantityTable() = default;

  /// Returns this table with one more quantity at its end. Throws as the constructor.
  [[nodiscard]] QuantityTable with(ResultQuantity quantity) const;

  /// The quantity of that name; nullptr if there is none. It lives as long as any copy of the table.
  [[nodiscard]] const ResultQuantity* find(std::string_view name) const&;
  const ResultQuantity* find(std::string_view name) const&& = delete;

  /// The quantity of that name. Throws std::invalid_argument if there is none.
  [[nodiscard]] const ResultQuantity& at(std::string_view name) const&;
  const ResultQuantity& at(std::string_view name) const&& = delete;

  [[nodiscard]] std::size_t size() const noexcept { return rows_->size(); }
  /// The quantity at an index of the table, index < size().
  [[nodiscard]] const ResultQuantity& operator[](std::size_t index) const { return (*rows_)[index]; }
  [[nodiscard]] auto begin() const noexcept { return rows_->begin(); }
  [[nodiscard]] auto end() const noexcept { return rows_->end(); }

 private:
  std::shared_ptr<const std::vector<ResultQuantity>> rows_;  // shared: studies, problems and tables copy it
};

/// The angles of single joints, which evaluate prints as lists: "joint1_angle_deg" at the end of a step from rest and
/// "rest_joint1_angle_deg" without current, for every joint that a chain may have, base to tip. They are not part of
/// standard_quantities(); studies add those that are asked for. A shorter actuator has no value for the others.
[[nodiscard]] std::span<const ResultQuantity> joint_quantities();

/// The quantities that `evaluate` prints. A program adds its own by `standard_quantities().with(...)`.
[[nodiscard]] const QuantityTable& standard_quantities();

}  // namespace coilwright::simulation
