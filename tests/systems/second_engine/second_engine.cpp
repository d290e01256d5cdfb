// What MuJoCo makes of fingers that grip an object, and of a robot that crawls.
// usage: second_engine grip|crawl SCENE.xml TORQUE.csv
//
// Prints JSON, SI. The scene has the bodies; its numeric elements say what is done with them (see second_engine.py).
// A joint whose name ends with a digit is driven by that joint's table of torque per ampere. This knows nothing of
// Coilwright.
#include <mujoco/mujoco.h>

#include <array>
#include <memory>
#include <string>

#include "exports/torque_table.hpp"
#include "systems/second_engine/crawling.hpp"
#include "systems/second_engine/gripping.hpp"
#include "systems/second_engine/scene.hpp"

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  std::array<char, 1000> error{};
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(mj_loadXML(argv[2], nullptr, error.data(), error.size()),
                                                           &mj_deleteModel);
  if (model == nullptr) second_engine::fail(error.data());
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()), &mj_deleteData);
  const Tables tables = tables_of(argv[3]);
  mj_forward(model.get(), data.get());
  if (std::string(argv[1]) == "grip")
    second_engine::grip(model.get(), data.get(), tables);
  else if (std::string(argv[1]) == "crawl")
    second_engine::crawl(model.get(), data.get(), tables);
  else
    return 2;
}
