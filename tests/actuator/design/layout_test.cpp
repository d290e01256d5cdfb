#include "coilwright/actuator/design/layout.hpp"

#include <gtest/gtest.h>

#include "actuator/paper_finger.hpp"

namespace coilwright::actuator {
namespace {

constexpr Component coil{.kind = ComponentKind::coil};
constexpr Component magnet{.kind = ComponentKind::magnet};

std::string kinds(const Layout& layout) {
  std::string out;
  for (const Component& component : layout) out += component.kind == ComponentKind::coil ? 'c' : 'm';
  return out;
}

TEST(Layout, IsThePapersForEachConfiguration) {
  EXPECT_EQ(kinds(layout_of(Configuration::A)), "cm");
  EXPECT_EQ(kinds(layout_of(Configuration::B)), "cmc");
  EXPECT_EQ(kinds(layout_of(Configuration::C)), "cmcmc");
  EXPECT_EQ(kinds(layout_of(Configuration::D)), "cmccmc");
}

TEST(Layout, CountsItsParts) {
  const Layout layout{magnet, coil, coil, magnet, coil, coil};
  EXPECT_EQ(coil_count(layout), 4);
  EXPECT_EQ(magnet_count(layout), 2);
}

TEST(Layout, AcceptsAnyAlternationAndTheLongestChain) {
  EXPECT_NO_THROW(check_layout({magnet, coil}));
  EXPECT_NO_THROW(check_layout({magnet, coil, coil, {.kind = ComponentKind::magnet, .polarity = -1}}));
  Layout longest;
  for (int i = 0; i < 17; ++i) longest.push_back(i % 2 == 0 ? coil : magnet);
  EXPECT_NO_THROW(check_layout(longest));
}

TEST(Layout, SaysWhichRuleItBreaks) {
  const auto text = [](const Layout& layout) { return error_text([&] { check_layout(layout); }); };
  EXPECT_EQ(text({}), "layout must have 2 to 17 components; got 0");
  EXPECT_EQ(text({coil}), "layout must have 2 to 17 components; got 1");
  EXPECT_EQ(text(Layout(18, coil)), "layout must have 2 to 17 components; got 18");
  EXPECT_EQ(text({coil, {.kind = ComponentKind::magnet, .polarity = 3}}), "layout: polarity 1 must be +1 or -1; got 3");
  EXPECT_EQ(text({coil, magnet, magnet, coil}),
            "layout: components 1 and 2 must not both be magnets (nothing keeps them apart)");
  EXPECT_EQ(text({coil, coil, coil}), "layout must have at least one magnet; got none");
  EXPECT_EQ(error_text([] { (void)layout_of(static_cast<Configuration>(7)); }), "configuration must be A, B, C or D");
}

// Two magnets cannot be neighbours, so a layout without coils is refused before anybody counts them.
TEST(Layout, WithoutCoilsHasMagnetsSideBySide) {
  EXPECT_EQ(error_text([] {
              check_layout({magnet, magnet});
            }),
            "layout: components 0 and 1 must not both be magnets (nothing keeps them apart)");
}

}  // namespace
}  // namespace coilwright::actuator
