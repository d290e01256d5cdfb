#include "coilwright/magnetics/field_places.hpp"

namespace coilwright::magnetics {

FieldPlaces field_places(std::span<const Body> bodies, const std::optional<Plate>& plate,
                         std::span<const Eigen::Vector3d> points, bool gradient) {
  std::vector<Body> sources(bodies.begin(), bodies.end());
  if (plate)
    for (const Body& body : bodies) sources.push_back(image_of(body, *plate));
  FieldPlaces out;
  if (gradient)
    out.samples = field(sources, points);
  else
    for (const Eigen::Vector3d& each : flux_density(sources, points)) out.samples.push_back({.flux_density = each});
  for (const Eigen::Vector3d& point : points) {
    std::size_t within = 0;
    std::size_t on_edge = 0;
    for (std::size_t i = bodies.size(); i > 0; --i) {
      if (is_inside(bodies[i - 1], point)) within = i;
      if (is_on_edge(bodies[i - 1], point)) on_edge = i;
    }
    out.within.push_back(within);
    out.on_edge.push_back(on_edge);
    out.in_iron.push_back(plate && plate->normal.dot(point - plate->position) < 0.0);
  }
  return out;
}

}  // namespace coilwright::magnetics
