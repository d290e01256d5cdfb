#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "coilwright/actuator/operating_point.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/text/json/node.hpp"

namespace coilwright::cli {

/// The runs behind a diagnosis, with what its declared and its corrected model show of them (cli/bench/diagnosis.hpp).
struct OpenedDiagnosis;

/// What the command line named, read once: the design that the bench starts from, and what else the page shows.
struct Bench {
  std::string shown;                                   ///< as it was named
  formats::ActuatorFile file{};                        ///< a design, with the operating point to start from
  text::Json further = text::Json::object();           ///< for the page: "study", "designs", "diagnosis"
  std::shared_ptr<const OpenedDiagnosis> diagnosis{};  ///< null if it is of none
};

/// Reads an actuator's file, or the folder of a size, pareto, sweep or diagnose. Throws InputError, also for a lumped
/// model. Without an operating point the current is what the parts bear for good, at most the wire's ampacity.
[[nodiscard]] Bench open_bench(const std::string& named, std::optional<double> current);

/// A design of the bench and its operating point.
struct Turned {
  actuator::Design design;
  actuator::OperatingPoint point;
};

/// The bench's design with changes "gap_mm=1.2" as of `evaluate --set`, and those of its operating point
/// ("current_A=1.4"), made. Throws InputError.
[[nodiscard]] Turned turned(const Bench& bench, const std::vector<std::string>& changes);

/// Every number of the bench's design and operating point: name, group, unit, meaning, range or words.
[[nodiscard]] text::Json knobs(const Bench& bench);

/// The value of each that the design has, by its name, in the unit of the name.
[[nodiscard]] text::Json knob_values(const Turned& design);

/// The design as an actuator's file.
[[nodiscard]] std::string actuator_text(const Bench& bench, const Turned& design);

/// Assembles it and computes its performance. Throws InputError with the reason why it has none.
[[nodiscard]] simulation::EvaluatedDesign evaluated(const Bench& bench, const Turned& design);

}  // namespace coilwright::cli
