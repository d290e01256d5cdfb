#include "coilwright/report/diagnosis/phase_table.hpp"

#include <fmt/format.h>

#include "coilwright/report/simulation/text_table.hpp"

namespace coilwright::report {
namespace {

using measurement::Phase;
using enum TextTable::Align;

void add(TextTable& table, const Phase& phase) {
  table.row({phase.name, fmt::format("{:.2f}", phase.seconds), fmt::format("{}", phase.simulated_runs)});
}

}  // namespace

std::string to_text(std::span<const Phase> phases) {
  if (phases.empty()) return {};
  TextTable table;
  table.row({"phase", "s", "simulated runs"});
  Phase total{.name = "total"};
  for (const Phase& phase : phases) {
    add(table, phase);
    total.seconds += phase.seconds;
    total.simulated_runs += phase.simulated_runs;
  }
  add(table, total);
  return table.text(2, {left, right, right});
}

}  // namespace coilwright::report
