#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "truth/laboratory/request.hpp"

namespace attribution::laboratory {

/// What is hidden: nothing; nothing but declared numbers far off; nothing in noise whose colour the records cannot
/// show; effects of the catalogue; an effect outside every catalogue.
enum class Category { nothing, far, colour_unknown, one, two, three, outsider };

[[nodiscard]] std::string_view name_of(Category category);

/// A set to be made and diagnosed.
struct Case {
  int number{};
  Category category{};
  std::vector<std::string> conditions{};  ///< names; "clean" for none
  truth::laboratory::Request request{};
};

/// development: sets by which the diagnosis may be improved. kept: fewer sets, of other seeds and other outsiders, for
/// the end. each_effect: every effect of the catalogue alone, where nothing else is wrong and where little is.
enum class PlanName { development, kept, each_effect };

/// Values of the first number of the effect, in the unit of its key, by the number of the set: what is to be hidden in
/// place of a drawn strength.
using Values = std::map<int, double>;

/// The sets of a plan, in an order in which each stretch has a bit of everything. development has 372: 160 with nothing
/// hidden (each fault alone, in pairs, all at once, each camera and programme), 14 with numbers far off, 12 in a colour
/// that cannot be known, 96 with one effect (each kind at least thrice), 36 with two, 14 with three, 40 with an
/// outsider. kept has 48. Where `values` has one for a set of one effect, that is hidden; otherwise two in three are 8
/// to 20 times as strong as the noise, one at its physical bound.
///
/// each_effect has each kind thrice, 8 to 20 times as strong as the noise: clean at 500 frames a second, at 30, and
/// with declared numbers off within their tolerances.
///
/// Another `seed` than 0 draws other sets of the same plan: sets that nobody has seen.
[[nodiscard]] std::vector<Case> plan(PlanName name, const Values& values = {}, std::uint64_t seed = 0);

/// "numbers+clocks".
[[nodiscard]] std::string joined(const std::vector<std::string>& conditions);

}  // namespace attribution::laboratory
