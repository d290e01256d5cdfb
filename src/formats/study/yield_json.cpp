#include "coilwright/formats/study/yield_json.hpp"

namespace coilwright::formats {
namespace {

using text::Json;

Json json_of(const sizing::Share& share) {
  return Json::object({{"share", share.value}, {"low", share.low}, {"high", share.high}});
}

Json json_of(const std::optional<sizing::SobolIndex>& index) {
  if (!index) return {};
  return Json::object({{"value", index->value}, {"low", index->low}, {"high", index->high}});
}

Json json_of(const sizing::BuiltQuantity& quantity) {
  Json out = Json::object({{"quantity", quantity.name},
                           {"nominal", quantity.nominal},
                           {"p05", quantity.p05},
                           {"p50", quantity.p50},
                           {"p95", quantity.p95}});
  if (!quantity.keeps) return out;
  out.set("limit", quantity.limit);
  out.set("keeps", json_of(*quantity.keeps));
  if (quantity.asked) out.set("asked", *quantity.asked);
  return out;
}

// By quantity, in their order.
Json indices_of(const std::vector<std::optional<sizing::SobolIndex>>& indices) {
  Json out = Json::array({});
  for (const auto& index : indices) out.add(json_of(index));
  return out;
}

}  // namespace

Json to_json(const sizing::Yield& yield) {
  Json quantities = Json::array({});
  for (const sizing::BuiltQuantity& quantity : yield.quantities) quantities.add(json_of(quantity));
  Json worths = Json::array({});
  for (const sizing::ScatterWorth& worth : yield.worths)
    worths.add(Json::object({{"scatter", worth.scatter},
                             {"first", indices_of(worth.first)},
                             {"total", indices_of(worth.total)},
                             {"keeps_all_at_half", json_of(worth.keeps_all)}}));
  return Json::object({{"builds", yield.builds},
                       {"not_built", yield.not_built},
                       {"keeps_all", json_of(yield.keeps_all)},
                       {"quantities", std::move(quantities)},
                       {"scatters", std::move(worths)}});
}

}  // namespace coilwright::formats
