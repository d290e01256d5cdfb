#pragma once

#include <array>
#include <string>
#include <string_view>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"
#include "coilwright/text/json/json.hpp"
#include "coilwright/units/unit.hpp"
#include "formats/actuator/part_numbers.hpp"

namespace coilwright::formats {

/// An object with the part's numbers, each in the unit of its key: read_numbers() of it is the part again, to rounding.
template <class Part, std::size_t Count>
[[nodiscard]] text::Json numbers_json(const Part& part, const std::array<PartKey<Part>, Count>& keys) {
  text::Json out = text::Json::object();
  for (const PartKey<Part>& each : keys)
    out.set(std::string(each.key), units::from_memory(part.*each.member, each.key));
  return out;
}

/// The key "magnet" of a pair.
[[nodiscard]] text::Json magnet_json(const magnetics::CylinderMagnet::Spec& magnet);

/// The key "coil" of a pair; where its current flows stands beside it (winding_word()).
[[nodiscard]] text::Json coil_json(const magnetics::ThickCoil::Spec& coil);

/// The word that read_winding() takes.
[[nodiscard]] std::string_view winding_word(magnetics::CurrentDistribution winding);

}  // namespace coilwright::formats
