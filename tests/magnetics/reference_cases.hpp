#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "coilwright/magnetics/cylinder_magnet.hpp"
#include "coilwright/magnetics/thick_coil.hpp"

// Reads the reference values of tests/data/magnetics (origin: tests/data/magnetics_SOURCES.md).
namespace coilwright::magnetics::reference {

inline nlohmann::json load(const std::string& file) {
  std::ifstream in(COILWRIGHT_TEST_DATA "/magnetics/" + file);
  return nlohmann::json::parse(in);
}

inline CurrentDistribution winding(const std::string& name) {
  if (name == "edge") return CurrentDistribution::paper_shells;
  return name == "mid" ? CurrentDistribution::layer_centres : CurrentDistribution::uniform;
}

inline ThickCoil coil(const nlohmann::json& c, const std::string& model) {
  return ThickCoil({.inner_radius = c["ri"],
                    .outer_radius = c["ro"],
                    .length = c["l"],
                    .turns_radial = c["Nr"],
                    .turns_axial = c["Nz"],
                    .winding = winding(model)});
}

inline CylinderMagnet magnet(const nlohmann::json& m) {
  return CylinderMagnet({.radius = m["R"], .length = m["l"], .remanence = m["J"]});
}

}  // namespace coilwright::magnetics::reference
