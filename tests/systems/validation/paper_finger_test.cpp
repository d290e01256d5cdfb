#include "coilwright/systems/validation/paper_finger.hpp"

#include <gtest/gtest.h>

#include <variant>

#include "coilwright/actuator/design/parameters.hpp"
#include "coilwright/formats/actuator/actuator_file.hpp"

namespace coilwright::systems::validation {
namespace {

TEST(PaperFinger, IsTheShippedFile) {
  const formats::ActuatorFile file =
      formats::read_actuator(COILWRIGHT_SOURCE_DIR "/configs/actuators/paper_finger.json");
  const actuator::Design& shipped = std::get<actuator::Design>(file.content);
  const actuator::Design built = paper_finger();
  for (const actuator::Parameter& parameter : actuator::parameters())
    EXPECT_EQ(parameter.get(built), parameter.get(shipped)) << parameter.name;
  EXPECT_EQ(built.layout.size(), shipped.layout.size());
  EXPECT_EQ(built.choices.winding, shipped.choices.winding);
  EXPECT_EQ(built.choices.torque, shipped.choices.torque);
  EXPECT_EQ(built.choices.faces, shipped.choices.faces);
  EXPECT_EQ(built.choices.masses, shipped.choices.masses);
}

}  // namespace
}  // namespace coilwright::systems::validation
