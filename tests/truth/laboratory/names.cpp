#include "truth/laboratory/names.hpp"

#include <array>
#include <cstddef>

namespace truth::laboratory {
namespace {

template <typename Choice, std::size_t n>
std::string_view name_in(const std::array<std::string_view, n>& names, Choice choice) {
  return names.at(static_cast<std::size_t>(choice));
}

}  // namespace

std::string_view name_of(Deviation deviation) {
  return name_in(std::array<std::string_view, 3>{"none", "within", "far"}, deviation);
}
std::string_view name_of(Tolerances tolerances) {
  return name_in(std::array<std::string_view, 3>{"exact", "listed", "absent"}, tolerances);
}
std::string_view name_of(InputLog log) {
  return name_in(std::array<std::string_view, 3>{"beside_pictures", "every_change", "own_samples"}, log);
}
std::string_view name_of(Colour colour) {
  return name_in(std::array<std::string_view, 4>{"white", "low_passed", "pink", "hum"}, colour);
}
std::string_view name_of(DeclaredFaces faces) {
  return name_in(std::array<std::string_view, 3>{"none", "absent", "elsewhere"}, faces);
}
std::string_view name_of(Programme programme) {
  return name_in(std::array<std::string_view, 6>{"paper", "few", "one", "sines", "rig_changes", "hold"}, programme);
}

}  // namespace truth::laboratory
