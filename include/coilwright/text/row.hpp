#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

#include "coilwright/text/rule.hpp"

namespace coilwright::text {

/// Whether a file or a command must say a number. `fixed`: it need not, and no study varies it.
enum class Need { optional, required, fixed };

/// All that is known of a number, whatever it is a number of.
struct RowFacts {
  std::string_view key;                       ///< in files, its unit at its end: --gap-mm as an option
  Rule rule = finite;                         ///< in that unit
  std::string_view meaning{};                 ///< one sentence without its point, its unit and its default
  Need need = Need::optional;                 ///< the default is that of a thing as it is made
  bool whole{};                               ///< a whole number
  std::span<const std::string_view> words{};  ///< of a choice, by its value from 0; empty for a number
  std::string_view also{};                    ///< another key of it, which files may have instead
};

/// A number of a `Thing`, or a choice. Readers, writers, schemas, options of commands and their defaults, tables of the
/// documentation and keywords of Python come from such rows, so that each fact stands once.
template <class Thing>
struct Row : RowFacts {
  std::optional<double> (*get)(const Thing&) = nullptr;  ///< SI (degC), or the place of a word; absent: not said
  void (*set)(Thing&, double) = nullptr;                 ///< the same
  double Thing::*member{};                               ///< where it is a number of the thing itself
  std::optional<double> Thing::*said{};                  ///< the same of a number that the thing may lack
};

/// The class that has a member.
template <class Pointer>
struct OwnerOf;
/// That of a pointer to a member.
template <class Thing, class Member>
struct OwnerOf<Member Thing::*> {
  using Type = Thing;  ///< that class
};

/// The row of the number to which pointers to members lead, one after the other: of a double, an int, an enumeration,
/// or a std::optional<double>.
template <auto First, auto... Rest>
[[nodiscard]] constexpr auto row(std::string_view key, const Rule& rule, std::string_view meaning,
                                 Need need = Need::optional) {
  using Thing = typename OwnerOf<decltype(First)>::Type;
  using Value = std::remove_cvref_t<decltype(((std::declval<Thing&>().*First).*....*Rest))>;
  Row<Thing> out{{.key = key, .rule = rule, .meaning = meaning, .need = need, .whole = std::is_same_v<Value, int>}};
  out.get = [](const Thing& thing) -> std::optional<double> {
    const auto& value = ((thing.*First).*....*Rest);
    if constexpr (std::is_same_v<Value, std::optional<double>>)
      return value;
    else
      return static_cast<double>(value);
  };
  out.set = [](Thing& thing, double value) {
    auto& place = ((thing.*First).*....*Rest);
    if constexpr (std::is_same_v<Value, std::optional<double>>)
      place = value;
    else
      place = static_cast<Value>(value);
  };
  if constexpr (sizeof...(Rest) == 0 && std::is_same_v<Value, double>) out.member = First;
  if constexpr (sizeof...(Rest) == 0 && std::is_same_v<Value, std::optional<double>>) out.said = First;
  return out;
}

/// The row of a choice, whose values count from 0 as `words` do.
template <auto First, auto... Rest>
[[nodiscard]] constexpr auto choice_row(std::string_view key, std::span<const std::string_view> words,
                                        std::string_view meaning, Need need = Need::optional) {
  auto out = row<First, Rest...>(key, finite, meaning, need);
  out.words = words;
  return out;
}

/// What a thing has that nobody said anything of, in the unit of the row's key; absent where it has nothing that may be
/// said.
[[nodiscard]] std::optional<double> usual_of(const RowFacts& row, const std::optional<double>& in_memory);

}  // namespace coilwright::text
