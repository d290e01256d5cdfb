#pragma once

#include <cstddef>
#include <optional>

#include "coilwright/page/folder_page.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/json/json.hpp"
#include "page/front_table.hpp"

namespace coilwright::page {

/// The design of a row, evaluated anew; nothing where the study has no such design, or it comes out with other
/// objectives than its row has.
[[nodiscard]] std::optional<sizing::EvaluatedDesign> evaluated_row(const sizing::DesignProblem& problem,
                                                                   const FrontTable& front, std::size_t row);

/// What a front's designs look like and how they move, for those rows that are drawn, to be read by the page's script:
/// `rows`, `poses` (three sections a row), `times_s`, `angle_deg` (bending angle, a list a row). A design whose
/// objectives come out other than its row has them is left out and counted in `differ`.
[[nodiscard]] text::Json front_pictures(const sizing::Study& study, const FrontTable& front, std::size_t most);

/// Every design of a front as an actuator file: `lines` of the first one's text, the places of those that differ from
/// row to row (`places`), and of every row what stands there (`texts`); a row whose text has another number of lines
/// has it as a whole, in `whole` by its number.
[[nodiscard]] text::Json front_actuators(const sizing::Study& study, const FrontTable& front);

}  // namespace coilwright::page
