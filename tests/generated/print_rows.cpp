// Prints the schemas of all numbers that have rows, by what they are of, for scripts/generate.py.
#include <iostream>
#include <span>

#include "coilwright/formats/systems/task_rows.hpp"
#include "coilwright/text/json/rows.hpp"

int main() {
  using namespace coilwright;
  using text::schema_of;
  const std::vector<text::Row<systems::gripper::GripperTask>> grip =
      formats::grip_rows({.object = {.shape = systems::gripper::ObjectShape::box}});
  std::cout << text::Json::object({{"grip", schema_of(std::span(grip))},
                                   {"crawl", schema_of(formats::crawl_rows())},
                                   {"drive", schema_of(formats::drive_rows())},
                                   {"driver", schema_of(formats::driver_rows())}})
                   .text();
}
