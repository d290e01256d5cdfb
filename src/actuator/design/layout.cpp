#include "coilwright/actuator/design/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "coilwright/mechanics/joint_vector.hpp"

namespace coilwright::actuator {

std::string_view name_of(Configuration configuration) {
  switch (configuration) {
    case Configuration::A:
      return "A";
    case Configuration::B:
      return "B";
    case Configuration::C:
      return "C";
    case Configuration::D:
      return "D";
  }
  return "";
}

Layout layout_of(Configuration configuration) {
  constexpr Component coil{.kind = ComponentKind::coil};
  constexpr Component magnet{.kind = ComponentKind::magnet};
  switch (configuration) {
    case Configuration::A:
      return {coil, magnet};
    case Configuration::B:
      return {coil, magnet, coil};
    case Configuration::C:
      return {coil, magnet, coil, magnet, coil};
    case Configuration::D:
      return {coil, magnet, coil, coil, magnet, coil};
  }
  throw std::invalid_argument("configuration must be A, B, C or D");
}

std::string text_of(const Layout& layout) {
  std::string text;
  for (const Component& component : layout)
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", component.polarity < 0 ? "-" : "",
                        component.kind == ComponentKind::coil ? "coil" : "magnet");
  return text;
}

void check_layout(const Layout& layout) {
  constexpr int longest = mechanics::max_joints + 1;
  if (layout.size() < 2 || layout.size() > longest)
    throw std::invalid_argument(fmt::format("layout must have 2 to {} components; got {}", longest, layout.size()));
  for (std::size_t i = 0; i < layout.size(); ++i) {
    if (layout[i].polarity != 1 && layout[i].polarity != -1)
      throw std::invalid_argument(fmt::format("layout: polarity {} must be +1 or -1; got {}", i, layout[i].polarity));
    if (i > 0 && layout[i].kind == ComponentKind::magnet && layout[i - 1].kind == ComponentKind::magnet)
      throw std::invalid_argument(
          fmt::format("layout: components {} and {} must not both be magnets (nothing keeps them apart)", i - 1, i));
  }
  if (coil_count(layout) == 0) throw std::invalid_argument("layout must have at least one coil; got none");
  if (magnet_count(layout) == 0) throw std::invalid_argument("layout must have at least one magnet; got none");
}

int coil_count(const Layout& layout) {
  return static_cast<int>(
      std::ranges::count_if(layout, [](const Component& c) { return c.kind == ComponentKind::coil; }));
}

int magnet_count(const Layout& layout) {
  return static_cast<int>(layout.size()) - coil_count(layout);
}

}  // namespace coilwright::actuator
