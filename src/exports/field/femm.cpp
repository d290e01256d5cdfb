#include "coilwright/exports/femm.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string>

#include "exports/field/femm_text.hpp"
#include "exports/field/field_pair.hpp"

namespace coilwright::exports {
namespace {

constexpr double mu0 = 4e-7 * std::numbers::pi;

std::string line(const FieldNumber& number) {
  return fmt::format("{} = {:.12g} -- {}\n", number.name, number.value, number.meaning);
}

std::string data(const FieldPair& pair, const Origin& origin) {
  std::string text;
  for (const std::string& words : about(pair, origin)) text += "-- " + words + "\n";
  text += "-- FEMM 4.2: File, Open Lua Script. Lengths in mm, the rest in SI.\n\n";
  for (const FieldNumber& number : shape_numbers(pair)) text += line(number);
  text += line({"recoil", pair.magnet.recoil_permeability, "relative permeability of the magnet"});
  const std::string from = fmt::format("A/m: the remanence of {:.6g} T over the permeability", pair.magnet.remanence);
  text += line({"coercivity", pair.magnet.remanence / (mu0 * pair.magnet.recoil_permeability), from});
  for (const FieldNumber& number : place_numbers(pair)) text += line(number);
  return text;
}

}  // namespace

std::vector<ExportedFile> femm(const ModelSubject& subject, const ExportSettings& settings) {
  const FieldPair pair = field_pair(subject.model, settings);
  return {{.name = "pair.lua",
           .text = data(pair, subject.origin) + std::string(femm_script),
           .left_out = beyond_the_pair(subject.model)},
          pair_file(pair)};
}

}  // namespace coilwright::exports
