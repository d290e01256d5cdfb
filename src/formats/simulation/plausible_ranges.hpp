#pragma once

#include <fmt/format.h>

#include <cstddef>

#include "coilwright/simulation/commanded_input.hpp"
#include "coilwright/text/csv/csv_table.hpp"
#include "coilwright/text/rule.hpp"

/// What a command over time, an experiment and a record may say: far beyond any laboratory, and near enough that
/// nothing overflows and a simulation ends.
namespace coilwright::formats {

inline constexpr text::Rule level_rule = text::Rule::between(-1e6, 1e6);  ///< of an input, in the column's unit
inline constexpr text::Rule time_rule = text::Rule::between(0.0, 1e5);    ///< s
inline constexpr text::Rule duration_rule = text::Rule::above(0.0).and_also(text::Rule::at_most(1e5));   ///< s
inline constexpr text::Rule frequency_rule = text::Rule::above(0.0).and_also(text::Rule::at_most(1e6));  ///< Hz
inline constexpr text::Rule measured_rule = text::Rule::between(-1e12, 1e12);  ///< of a record, in SI
/// A standard deviation, in the column's unit. Outside, no instrument: a fit would drown in it, or overflow.
inline constexpr text::Rule sigma_rule = text::Rule::between(1e-12, 1e12);

/// Refuses a table over time with more samples than a simulation holds, naming the last one that there may be.
inline void require_few_samples(const text::CsvTable& table) {
  const auto most = static_cast<std::size_t>(simulation::most_samples);
  if (table.rows() <= most + 1) return;
  throw table.error("time", most,
                    fmt::format("must be the last: there may be {} intervals, and the file has {}; keep one row of {}, "
                                "or cut the file",
                                most, table.rows() - 1, (table.rows() - 2 + most) / most));
}

}  // namespace coilwright::formats
