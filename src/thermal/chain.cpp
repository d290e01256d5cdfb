#include "coilwright/thermal/chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "check.hpp"
#include "coilwright/thermal/paths.hpp"

namespace coilwright::thermal {
namespace {

// A round bar of this share of a square one's side has the same shape factor about a cylinder in its middle, 2 pi L /
// ln(1.08 w / D) (Incropera and DeWitt, table 4.1).
constexpr double round_bar = 0.54;

// Between the faces of an open joint, W/(m2 K): 4 sigma T^3 / (2 / 0.9 - 1) at 80 degC, emissivity of silicone 0.9.
constexpr double face_radiation = 8.2;

// Of a square section with even heat: heat leaving per surface and kelvin of its mean above the surface, times the side
// over the conductivity (mean 0.0351 q w^2 / k; Carslaw and Jaeger, section 5.3).
constexpr double square_section = 7.1;

// Gauss and Legendre, four points.
constexpr std::array<double, 4> gauss_points{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                             0.8611363115940526};
constexpr std::array<double, 4> gauss_weights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                              0.3478548451374538};

void check_segment(const HeatChain& chain, std::size_t index) {
  const HeatSegment& segment = chain.segments[index];
  const auto field = [index](std::string_view member) { return Field{"segments", index, member}; };
  require_positive(field("core_length"), segment.core_length);
  const double widest = 0.5 * std::min(chain.width, chain.height);
  if (!(segment.core_radius > 0.0 && segment.core_radius < widest)) {
    reject(field("core_radius"), fmt::format("> 0 and below {:.6g} m, half the body's smaller side", widest),
           segment.core_radius);
  }
  require(segment.bore_radius >= 0.0 && segment.bore_radius < segment.core_radius, field("bore_radius"),
          ">= 0 and below core_radius", segment.bore_radius);
  const double below = chain.axis_offset + 0.5 * chain.hinge_layer;
  require(segment.core_radius < below && segment.core_radius < chain.height - below, field("core_radius"),
          "below the axis's distance from the bottom and from the top", segment.core_radius);
  require_positive(field("core_conductivity"), segment.core_conductivity);
  require_positive(field("core_heat_capacity"), segment.core_heat_capacity);
  require_positive(field("wall"), segment.wall);
  require_not_negative(field("solid_end"), segment.solid_end);
}

void check(const HeatChain& chain) {
  require_positive({"width"}, chain.width);
  require_positive({"height"}, chain.height);
  require(chain.hinge_layer > 0.0 && chain.hinge_layer < chain.height, {"hinge_layer"}, "> 0 and below the height",
          chain.hinge_layer);
  require(std::isfinite(chain.axis_offset) && chain.axis_offset > 0.0, {"axis_offset"}, "finite and > 0",
          chain.axis_offset);
  require_positive({"heat_transfer"}, chain.heat_transfer);
  require_positive({"silicone_conductivity"}, chain.silicone_conductivity);
  require_positive({"silicone_heat_capacity"}, chain.silicone_heat_capacity);
  require_positive({"air_conductivity"}, chain.air_conductivity);
  if (chain.bottom) {
    require_positive({"bottom.conductivity"}, chain.bottom->conductivity);
    require_positive({"bottom.heat_capacity"}, chain.bottom->heat_capacity);
  }
  const std::size_t segments = chain.segments.size();
  require_count({"segments"}, segments, 1, most_nodes / 2 - 1);
  require_count({"joint_angles"}, chain.joint_angles.size(), segments - 1, segments - 1);
  for (std::size_t i = 0; i < segments; ++i) check_segment(chain, i);
  for (std::size_t i = 0; i + 1 < segments; ++i)
    require(chain.joint_angles[i] >= 0.0 && chain.joint_angles[i] <= std::numbers::pi, {"joint_angles", i},
            "from 0 to pi rad", chain.joint_angles[i]);
}

// Below it a joint is as good as closed, and air between its faces would conduct beyond all numbers, rad.
constexpr double least_opening = 1e-9;

double disc(double radius) {
  return std::numbers::pi * radius * radius;
}

// Times the conductivity: resistance by which heat spreads from a disc over a bar of that section, 1/m (isothermal disc
// in a flux tube; Yovanovich and Marotta in Bejan and Kraus, Heat Transfer Handbook, chapter 4).
double spreading(double radius, double section) {
  const double e = std::min(1.0, radius / std::sqrt(section / std::numbers::pi));
  const double cube = e * e * e;
  return std::max(0.0, 1.0 - 1.40925 * e + 0.29591 * cube + 0.05254 * cube * e * e) / (4.0 * radius);
}

// Geometry of one segment that several paths share.
struct Box {
  double length{};     // walls included, m
  double core_face{};  // area by which the core faces its neighbours, m2
  double rim{};        // the rest of the body's section, m2
  RingConduction core{};
};

Box box_of(const HeatChain& chain, const HeatSegment& segment) {
  Box box{.length = segment.core_length + 2.0 * segment.wall,
          .core_face = disc(segment.core_radius) - disc(segment.bore_radius),
          .rim = chain.width * chain.height - disc(segment.core_radius),
          .core = ring_conduction({.inner_radius = segment.bore_radius,
                                   .outer_radius = segment.core_radius,
                                   .length = segment.core_length,
                                   .conductivity = segment.core_conductivity})};
  return box;
}

// What two linked places do to the nodes behind them once the places themselves are eliminated, W/K.
struct Through {
  double link{};
  double first_to_ambient{};
  double second_to_ambient{};
};

// The body's section, of one silicone or of a bottom layer and what is above it.
struct Section {
  double area{};           // m2
  double conductivity{};   // along the body: side by side, W/(m K)
  double heat_capacity{};  // per volume, J/(m3 K)
};

Section section_of(const HeatChain& chain) {
  Section out{.area = chain.width * chain.height,
              .conductivity = chain.silicone_conductivity,
              .heat_capacity = chain.silicone_heat_capacity};
  if (chain.bottom) {
    const double share = chain.hinge_layer / chain.height;
    out.conductivity += share * (chain.bottom->conductivity - out.conductivity);
    out.heat_capacity += share * (chain.bottom->heat_capacity - out.heat_capacity);
  }
  return out;
}

// One of the four sides of the section, seen from the axis of the cores.
struct Side {
  double distance{};  // of the axis, m
  double layer{};     // of that the bottom layer's, m
};

std::array<Side, 4> sides_of(const HeatChain& chain) {
  const double bottom = chain.axis_offset + 0.5 * chain.hinge_layer;
  const Side half_width{.distance = 0.5 * chain.width};
  return {Side{.distance = bottom, .layer = chain.bottom ? chain.hinge_layer : 0.0},
          Side{.distance = chain.height - bottom}, half_width, half_width};
}

// Thermal resistance times length and angle of a sector from a core's surface to that of a side, at `away` times the
// side's distance, m K/W. Heat that turns aside is left out.
double sector_resistance(const HeatChain& chain, const Side& side, double away, double core_radius) {
  if (side.layer == 0.0) return std::log(side.distance * away / core_radius) / chain.silicone_conductivity;
  const double above = std::max(core_radius, (side.distance - side.layer) * away);
  return std::log(above / core_radius) / chain.silicone_conductivity +
         std::log(side.distance * away / above) / chain.bottom->conductivity;
}

// From where on heat leaves a sector, likewise.
double film_resistance(const HeatChain& chain, const Side& side, double away) {
  return 1.0 / (chain.heat_transfer * side.distance * away * away);
}

// Two faces of one joint, each with its conductance to the node behind it, with one to ambient and one to each other.
Through through_faces(double first, double second, double across, double lost) {
  const double a = first + lost;
  const double b = second + lost;
  const double determinant = a * b + across * (a + b);
  return {.link = first * second * across / determinant,
          .first_to_ambient = first * lost * (b + 2.0 * across) / determinant,
          .second_to_ambient = second * lost * (a + 2.0 * across) / determinant};
}

class Builder {
 public:
  explicit Builder(const HeatChain& chain) : chain_{chain}, section_{section_of(chain)} {
    spec_.ambient = chain.ambient;
    spec_.temperature_coefficient = chain.temperature_coefficient;
    for (const HeatSegment& segment : chain.segments) boxes_.push_back(box_of(chain, segment));
    for (const HeatSegment& segment : chain.segments)
      spec_.nodes.push_back({.kind = segment.kind,
                             .heat_capacity = segment.core_heat_capacity,
                             .resistance = segment.resistance,
                             .temperature_limit = segment.temperature_limit,
                             .current_share = segment.current_share});
    for (std::size_t i = 0; i < boxes_.size(); ++i) add_jacket(i);
    for (std::size_t j = 0; j < chain.joint_angles.size(); ++j) add_joint(j);
    add_solid_end(0);
    if (boxes_.size() > 1) add_solid_end(boxes_.size() - 1);
    add_hot_spots();
  }

  [[nodiscard]] Network network() && { return Network(std::move(spec_)); }

  // Of the hottest place of the outer surface, degC.
  [[nodiscard]] double skin(const NodeVector& temperatures) const {
    double hottest = chain_.ambient;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const double core = temperatures[static_cast<Eigen::Index>(core_node(i))];
      const double around = temperatures[static_cast<Eigen::Index>(jacket(i))];
      const double surface = core - within_core_[i] * (core - around);
      for (const Side& side : sides_of(chain_)) {
        const double film = film_resistance(chain_, side, 1.0);
        const double wall = sector_resistance(chain_, side, 1.0, chain_.segments[i].core_radius);
        hottest = std::max(hottest, chain_.ambient + (surface - chain_.ambient) * film / (wall + film));
      }
    }
    return hottest;
  }
  // What leaves through the film, per its area, degC.
  [[nodiscard]] double mean_surface(const NodeVector& temperatures) const {
    double lost = 0.0;
    for (std::size_t i = 0; i < nodes(); ++i)
      lost += spec_.nodes[i].ambient_conductance * (temperatures[static_cast<Eigen::Index>(i)] - chain_.ambient);
    return chain_.ambient + lost / (chain_.heat_transfer * exposed_);
  }
  [[nodiscard]] std::size_t nodes() const { return spec_.nodes.size(); }

 private:
  [[nodiscard]] std::size_t jacket(std::size_t i) const { return jacket_node(boxes_.size(), i); }

  // From the middle of a core to its face of `area`, through the segment's wall, W/K.
  [[nodiscard]] double core_to_face(std::size_t i, double area) const {
    const double wall = chain_.silicone_conductivity * area / chain_.segments[i].wall;
    const double core = boxes_[i].core.to_end * area / boxes_[i].core_face;
    return core * wall / (core + wall);
  }

  [[nodiscard]] double jacket_to_face(std::size_t i, double area) const {
    return jacket_to_face(i, area, chain_.silicone_conductivity);
  }
  [[nodiscard]] double jacket_to_face(std::size_t i, double area, double conductivity) const {
    return conductivity * area / (0.5 * boxes_[i].length);
  }

  void link(std::size_t first, std::size_t second, double conductance) {
    spec_.links.push_back({.first = first, .second = second, .conductance = conductance});
  }

  // From a core's surface to ambient through the sides, W/K: sector by sector about the axis, each with its own wall
  // and film. Heat that turns aside in the silicone is left out, which makes this a lower bound.
  [[nodiscard]] double through_sides(std::size_t i) const {
    const auto [bottom, top, left, right] = sides_of(chain_);
    double half = 0.0;  // left and right are alike
    const auto add_wall = [&](const Side& side, double extent) {
      const double widest = std::atan2(extent, side.distance);
      for (std::size_t n = 0; n < gauss_points.size(); ++n) {
        const double away = 1.0 / std::cos(0.5 * widest * (1.0 + gauss_points[n]));
        half += 0.5 * widest * gauss_weights[n] /
                (sector_resistance(chain_, side, away, chain_.segments[i].core_radius) +
                 film_resistance(chain_, side, away));
      }
    };
    add_wall(bottom, left.distance);
    add_wall(top, left.distance);
    add_wall(left, bottom.distance);
    add_wall(right, top.distance);
    return boxes_[i].length * 2.0 * half;
  }

  // The jacket is as warm as its silicone's mean under a steady flow, with the profile of a round one.
  void add_jacket(std::size_t i) {
    const HeatSegment& segment = chain_.segments[i];
    const Box& box = boxes_[i];
    const double side = std::sqrt(chain_.width * chain_.height);
    const double swell = round_bar * side / segment.core_radius;  // outer radius over the core's
    const double turn = std::log(swell);
    const double fall = swell * swell / (swell * swell - 1.0) - 0.5 / turn;  // of the mean, of that to the surface
    const double surface = 2.0 * (chain_.width + chain_.height) * box.length;
    const double outside = chain_.heat_transfer * surface;
    exposed_ += surface;
    const double inside = 1.0 / (1.0 / through_sides(i) - 1.0 / outside);
    spec_.nodes.push_back(
        {.kind = NodeKind::silicone,
         .ambient_conductance = 1.0 / ((1.0 - fall) / inside + 1.0 / outside),
         .heat_capacity = chain_.silicone_heat_capacity * (chain_.width * chain_.height * box.length -
                                                           disc(segment.core_radius) * segment.core_length) +
                          (section_.heat_capacity - chain_.silicone_heat_capacity) * section_.area * box.length});
    const double across = 1.0 / box.core.to_side + fall / inside;
    link(core_node(i), jacket(i), 1.0 / across);
    within_core_.push_back(1.0 / (box.core.to_side * across));
  }

  void add_joint(std::size_t j) {
    const double angle = chain_.joint_angles[j];
    const std::size_t k = j + 1;
    const double radius = std::min(chain_.segments[j].core_radius, chain_.segments[k].core_radius);
    const double cores = std::min({boxes_[j].core_face, boxes_[k].core_face, disc(radius)});
    const double strip = std::min(chain_.width * chain_.hinge_layer, std::min(boxes_[j].rim, boxes_[k].rim));
    const double rims = std::min(boxes_[j].rim, boxes_[k].rim) - (angle < least_opening ? 0.0 : strip);
    const double pair[2] = {core_to_face(j, cores), core_to_face(k, cores)};
    const double rim_pair[2] = {jacket_to_face(j, rims), jacket_to_face(k, rims)};
    if (angle < least_opening) {
      link(core_node(j), core_node(k), pair[0] * pair[1] / (pair[0] + pair[1]));
      link(jacket(j), jacket(k), rim_pair[0] * rim_pair[1] / (rim_pair[0] + rim_pair[1]));
      return;
    }
    const double layer = chain_.bottom ? chain_.bottom->conductivity : chain_.silicone_conductivity;
    const double ends[2] = {jacket_to_face(j, strip, layer), jacket_to_face(k, strip, layer)};
    link(jacket(j), jacket(k), ends[0] * ends[1] / (ends[0] + ends[1]));
    const double share = open_face_share(angle, (chain_.height - chain_.hinge_layer) / chain_.width);
    const double between = face_radiation * (1.0 - share);
    const double lost = chain_.heat_transfer * share;
    exposed_ += 2.0 * share * (cores + rims);
    // Air across the faces, whose distance grows from the hinge axis: over the cores and over all, W/K.
    const double air_cores =
        chain_.air_conductivity * cores /
        equivalent_air_gap({.angle = angle, .hinge_distance = chain_.axis_offset, .core_radius = radius});
    const double air_all = chain_.air_conductivity * chain_.width / angle *
                           std::log((chain_.height - 0.5 * chain_.hinge_layer) / (0.5 * chain_.hinge_layer));
    const double air_rims = std::max(0.0, air_all - air_cores);
    join(core_node(j), core_node(k), through_faces(pair[0], pair[1], air_cores + between * cores, lost * cores));
    join(jacket(j), jacket(k), through_faces(rim_pair[0], rim_pair[1], air_rims + between * rims, lost * rims));
  }

  void join(std::size_t first, std::size_t second, const Through& through) {
    link(first, second, through.link);
    spec_.nodes[first].ambient_conductance += through.first_to_ambient;
    spec_.nodes[second].ambient_conductance += through.second_to_ambient;
  }

  // Core and jacket meet the bar at its root, a place without capacity: a star, written as a triangle.
  void add_solid_end(std::size_t i) {
    const double length = chain_.segments[i].solid_end;
    const double section = section_.area;
    const double rim = jacket_to_face(i, boxes_[i].rim, section_.conductivity);
    double core = core_to_face(i, boxes_[i].core_face);
    if (length == 0.0) return add_bare_end(i, core, rim);
    const double perimeter = 2.0 * (chain_.width + chain_.height);
    exposed_ += perimeter * length + section;
    // From the bar's mean to its surface: 7.1 k over the hydraulic diameter, of a square section with even heat.
    const double hydraulic = 2.0 * section / (chain_.width + chain_.height);
    const double within = square_section * section_.conductivity / hydraulic;
    const double film = chain_.heat_transfer * within / (chain_.heat_transfer + within);
    const SolidEndNode end = solid_end_node({.length = length,
                                             .section = section,
                                             .perimeter = perimeter,
                                             .conductivity = section_.conductivity,
                                             .heat_capacity = section_.heat_capacity,
                                             .heat_transfer = film});
    core = 1.0 / (1.0 / core + spreading(chain_.segments[i].core_radius, section) / chain_.silicone_conductivity);
    const std::size_t node = spec_.nodes.size();
    spec_.nodes.push_back(
        {.kind = NodeKind::silicone, .ambient_conductance = end.to_ambient, .heat_capacity = end.heat_capacity});
    const double all = core + rim + end.to_root;
    link(core_node(i), jacket(i), core * rim / all);
    link(core_node(i), node, core * end.to_root / all);
    link(jacket(i), node, rim * end.to_root / all);
  }

  void add_bare_end(std::size_t i, double core, double rim) {
    const auto in_series = [](double a, double b) { return a * b / (a + b); };
    exposed_ += boxes_[i].core_face + boxes_[i].rim;
    spec_.nodes[core_node(i)].ambient_conductance += in_series(core, chain_.heat_transfer * boxes_[i].core_face);
    spec_.nodes[jacket(i)].ambient_conductance += in_series(rim, chain_.heat_transfer * boxes_[i].rim);
  }

  // Heat leaves a coil as its conductances share it out; each share has its own profile.
  void add_hot_spots() {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (chain_.segments[i].kind != NodeKind::coil) continue;
      const RingConduction& core = boxes_[i].core;
      double side = 0.0;
      double all = spec_.nodes[i].ambient_conductance;
      for (const Link& each : spec_.links) {
        if (each.first != i && each.second != i) continue;
        all += each.conductance;
        if (each.second == jacket(i)) side += each.conductance;
      }
      const double share = side / all;
      spec_.nodes[i].hot_spot_resistance = share * core.hot_spot_by_side + (1.0 - share) * core.hot_spot_by_ends;
    }
  }

  const HeatChain& chain_;
  Section section_;
  Network::Spec spec_;
  std::vector<Box> boxes_;
  // Of each segment: what of the fall from its core's mean to its jacket's lies within the core.
  std::vector<double> within_core_;
  double exposed_{};  // area that loses heat to ambient, m2
};

Builder builder_for(const HeatChain& chain, const NodeVector& temperatures) {
  check(chain);
  Builder builder(chain);
  require_count({"temperatures"}, static_cast<std::size_t>(temperatures.size()), builder.nodes(), builder.nodes());
  return builder;
}

}  // namespace

Network build_network(const HeatChain& chain) {
  check(chain);
  return Builder(chain).network();
}

double skin_temperature(const HeatChain& chain, const NodeVector& temperatures) {
  return builder_for(chain, temperatures).skin(temperatures);
}

double mean_surface_temperature(const HeatChain& chain, const NodeVector& temperatures) {
  return builder_for(chain, temperatures).mean_surface(temperatures);
}

}  // namespace coilwright::thermal
