#include "coilwright/simulation/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace coilwright::simulation {
namespace {

void require(bool kept, const ResultQuantity& quantity, std::string_view rule) {
  if (!kept) throw std::invalid_argument(fmt::format("quantity \"{}\": {}", quantity.name, rule));
}

}  // namespace

std::optional<actuator::HeldCases> either(std::optional<actuator::HeldCases> one,
                                          std::optional<actuator::HeldCases> other) {
  if (!one) return other;
  return !other || *one == *other ? *one : actuator::HeldCases::both;
}

void validate_quantity(const ResultQuantity& quantity) {
  require(!quantity.name.empty(), quantity, "the name must not be empty");
  require(!quantity.meaning.empty(), quantity, "the meaning must not be empty");
  require(std::isfinite(quantity.scale) && quantity.scale > 0.0, quantity, "the scale must be finite and > 0");
  require(static_cast<bool>(quantity.value), quantity, "the function that gives the value must not be empty");
}

QuantityTable::QuantityTable(std::vector<ResultQuantity> rows) {
  std::set<std::string_view> names;
  for (const ResultQuantity& quantity : rows) {
    validate_quantity(quantity);
    require(names.insert(quantity.name).second, quantity, "the name must not be taken by another quantity");
  }
  rows_ = std::make_shared<const std::vector<ResultQuantity>>(std::move(rows));
}

QuantityTable QuantityTable::with(ResultQuantity quantity) const {
  std::vector<ResultQuantity> rows = *rows_;
  rows.push_back(std::move(quantity));
  return QuantityTable{std::move(rows)};
}

const ResultQuantity* QuantityTable::find(std::string_view name) const& {
  const auto found = std::ranges::find(*rows_, name, &ResultQuantity::name);
  return found == rows_->end() ? nullptr : &*found;
}

const ResultQuantity& QuantityTable::at(std::string_view name) const& {
  if (const ResultQuantity* quantity = find(name)) return *quantity;
  throw std::invalid_argument(fmt::format("there is no quantity \"{}\"", name));
}

}  // namespace coilwright::simulation
