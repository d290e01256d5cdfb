#pragma once

#include <optional>
#include <span>
#include <vector>

#include "coilwright/systems/crawl_quantities.hpp"
#include "coilwright/systems/driven_actuator.hpp"
#include "coilwright/systems/driver_quantities.hpp"
#include "coilwright/systems/gripper/quantities.hpp"
#include "coilwright/text/row.hpp"

namespace coilwright::formats {

// The numbers of what is built from an actuator: of the blocks of a study and their variables, of the options of grip,
// crawl and drive, and of the keywords of Python. scripts/generate.py writes schemas, tables and keywords from them.

/// Those of a crawling robot.
[[nodiscard]] std::span<const text::Row<systems::CrawlTask>> crawl_rows();

/// Those of a gripper with an object of the shape that `base` has and as many fingers. A height belongs to what has
/// flat sides alone, a place beside the axis to two fingers.
[[nodiscard]] std::vector<text::Row<systems::gripper::GripperTask>> grip_rows(
    const systems::gripper::GripperTask& base);

/// Those of the pulsed supply of a study.
[[nodiscard]] std::span<const text::Row<systems::DriverTask>> driver_rows();

/// The question of drive with the bridge and the cell of which it is about one.
struct DriveTask {
  systems::DriveQuestion question{};  ///< without its driver
  drive::HBridge bridge{};            ///< the driver where the cell has no voltage
  systems::CellDrive cell{};          ///< the driver where it has one; its resistance is that of the bridge's supply
  std::optional<double> diode_voltage{};  ///< of either, V; absent: its own

  /// The question about its driver.
  [[nodiscard]] systems::DriveQuestion asked() const;
};

/// Those of a drive.
[[nodiscard]] std::span<const text::Row<DriveTask>> drive_rows();

}  // namespace coilwright::formats
