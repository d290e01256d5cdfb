#include "coilwright/exports/getdp.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "exports/field/field_pair.hpp"
#include "exports/field/getdp_texts.hpp"

namespace coilwright::exports {
namespace {

std::string getdp_line(const FieldNumber& number) {
  return fmt::format("  {} = {:.12g},  // {}\n", number.name, number.value, number.meaning);
}

std::string getdp_data(const FieldPair& pair, const Origin& origin) {
  std::string text;
  for (const std::string& words : about(pair, origin)) text += "// " + words + "\n";
  text += "// Lengths in mm, the rest in SI. Each may be set on the command line: -setnumber gap 2.\n";
  text += "DefineConstant[\n";
  for (const FieldNumber& number : shape_numbers(pair)) text += getdp_line(number);
  text += getdp_line({"remanence", pair.magnet.remanence, "T, along the axis, away from the coil"});
  text += getdp_line({"recoil", pair.magnet.recoil_permeability, "relative permeability of the magnet"});
  for (const FieldNumber& number : place_numbers(pair)) text += getdp_line(number);
  text += "  fineness = 1,  // all lengths of elements are divided by it\n";
  text += "  order = 2  // of the elements, 1 or 2\n];\n";
  return text;
}

}  // namespace

std::vector<ExportedFile> getdp(const ModelSubject& subject, const ExportSettings& settings) {
  const FieldPair pair = field_pair(subject.model, settings);
  return {
      {.name = "pair_data.pro", .text = getdp_data(pair, subject.origin), .left_out = beyond_the_pair(subject.model)},
      {.name = "pair.geo", .text = std::string(getdp_geometry)},
      {.name = "pair.pro", .text = std::string(getdp_problem)},
      pair_file(pair)};
}

}  // namespace coilwright::exports
