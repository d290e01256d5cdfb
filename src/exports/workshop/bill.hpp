#pragma once

#include <string>
#include <vector>

#include "coilwright/exports/settings.hpp"
#include "coilwright/exports/subject.hpp"
#include "exports/cast.hpp"
#include "exports/workshop/winding_sheet.hpp"

namespace coilwright::exports {

/// One row of the bill of materials.
struct BillRow {
  std::string item;
  std::string specification;  ///< what to order
  std::string quantity;       ///< with its unit
  double price{};             ///< US$, as actuator::cost_of() splits them
};

/// Everything that one actuator is made of, and what drives it. The prices are those of the source paper's Table III,
/// scaled: the sum of all rows but the last is actuator::Cost::total().
[[nodiscard]] std::vector<BillRow> bill_of_materials(const DesignSubject& subject, const ExportSettings& settings,
                                                     const WindingSheet& winding, const Cast& cast);

/// materials.csv.
[[nodiscard]] std::string materials_csv(const std::vector<BillRow>& rows);

}  // namespace coilwright::exports
