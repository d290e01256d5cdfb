#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "exports/workshop/assembly_order.hpp"
#include "exports/workshop/bill.hpp"
#include "exports/workshop/recipe.hpp"
#include "exports/workshop/winding_sheet.hpp"

namespace coilwright::exports {

/// The sections of workshop.html, each a heading with what stands below it. `figure` is HTML.
[[nodiscard]] std::string winding_section(const WindingSheet& sheet);
[[nodiscard]] std::string bill_section(const std::vector<BillRow>& rows);
[[nodiscard]] std::string recipe_section(const Recipe& recipe);
[[nodiscard]] std::string assembly_section(const AssemblyOrder& order, std::string_view figure);

}  // namespace coilwright::exports
