#include "coilwright/exports/kinds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <variant>

#include "coilwright/units/unit.hpp"
#include "exports/finger.hpp"

namespace coilwright::exports {
namespace {

DesignSubject finger() {
  return subject_of(actuator::Design{});
}

TEST(ExportKinds, HaveDistinctNamesAndSayWhatTheyGive) {
  std::set<std::string_view> names;
  for (const ExportKind& kind : export_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(kind.gives.empty()) << kind.name;
    EXPECT_EQ(kind.use.back(), '.') << kind.name;
    EXPECT_EQ(find_export_kind(kind.name), &kind);
  }
  EXPECT_EQ(find_export_kind("banana"), nullptr);
}

TEST(ExportKinds, NameOnlySettingsThatThereAre) {
  for (const ExportKind& kind : export_kinds())
    for (const std::string_view name : kind.settings)
      EXPECT_EQ(std::ranges::count(export_settings(), name, &ExportSetting::name), 1) << kind.name << " " << name;
}

// A setting's default must be one that the command line itself would take.
TEST(ExportSettings, HaveDefaultsWithinTheirBounds) {
  for (const ExportSetting& setting : export_settings()) {
    const double value = units::from_memory(ExportSettings{}.*setting.value, setting.name);
    if (value == 0.0) continue;  // not given
    EXPECT_GE(value, setting.lowest) << setting.name;
    EXPECT_LE(value, setting.highest) << setting.name;
  }
}

TEST(ExportFiles, HavePlainDistinctNamesAndTextThatEndsWithANewline) {
  const DesignSubject subject = finger();
  for (const ExportKind& kind : export_kinds()) {
    std::set<std::string> names;
    for (const ExportedFile& file : export_files(kind, subject, {})) {
      EXPECT_TRUE(names.insert(file.name).second) << file.name;
      EXPECT_EQ(file.name.find('/'), std::string::npos) << file.name;
      ASSERT_FALSE(file.text.empty()) << file.name;
      EXPECT_EQ(file.text.back(), '\n') << file.name;
    }
    EXPECT_FALSE(names.empty()) << kind.name;
  }
}

TEST(ExportFiles, RefuseALumpedModelWhereAGeometryIsNeeded) {
  const ModelSubject subject{.origin = {}, .model = finger().assembly.model};
  for (const ExportKind& kind : export_kinds()) {
    if (std::holds_alternative<ModelExport>(kind.write_text)) {
      EXPECT_FALSE(export_files(kind, subject, {}).empty()) << kind.name;
      continue;
    }
    try {
      static_cast<void>(export_files(kind, subject, {}));
      FAIL() << kind.name;
    } catch (const std::invalid_argument& rule) {
      EXPECT_EQ(rule.what(), std::string(kind.name) + " needs the geometry of a design (actuator/1)");
    }
  }
}

}  // namespace
}  // namespace coilwright::exports
