#include "coilwright/actuator/design/segments.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "actuator/paper_finger.hpp"
#include "coilwright/actuator/design/dimensions.hpp"
#include "coilwright/winding/winding.hpp"

namespace coilwright::actuator {
namespace {

// General sizes: magnet wider than the coil, no two lengths alike.
Design uneven_design() {
  Design design = paper_geometry();
  design.choices.masses = SegmentMass::rigid_bodies;
  design.coil = {.inner_radius = 2.7e-3, .turns_radial = 11, .turns_axial = 26, .wire_gauge = 29};
  design.magnet.radius = 8.3e-3;
  design.magnet.length = 4.9e-3;
  design.body.bottom_layer = 2.1e-3;
  design.body.bottom_wall = 0.4e-3;
  return design;
}

struct Moments {
  double mass{};
  double along{};
  double offset{};
  double inertia{};
};

// A segment as a field of density, summed over the cells of a grid: nothing of the code's closed forms.
Moments summed(const Design& design, const Dimensions& size, int index, int cells) {
  const bool magnet = design.layout[static_cast<std::size_t>(index)].kind == ComponentKind::magnet;
  const double half_pitch = magnet ? size.magnet_half_pitch : size.coil_half_pitch;
  const double core_length = magnet ? design.magnet.length : size.coil_length;
  const double inner = magnet ? 0.0 : design.coil.inner_radius;
  const double outer = magnet ? design.magnet.radius : size.coil_outer_radius;
  const double rear = index == 0 ? design.body.rear_length : 0.0;
  const bool last = index + 1 == static_cast<int>(design.layout.size());
  const double length = rear + 2.0 * half_pitch + (last ? design.body.front_length : 0.0);
  const double core_density =
      magnet ? design.magnet.density
             : winding_of(design).copper_mass() / (M_PI * (outer * outer - inner * inner) * core_length);
  const double bottom = -0.5 * design.body.bottom_layer;
  const double dx = length / cells;
  const double dy = size.height / cells;
  const double dz = size.width / cells;
  Moments sum;
  double second = 0.0;
  for (int i = 0; i < cells; ++i) {
    const double x = (i + 0.5) * dx;
    const bool beside_core = std::abs(x - rear - half_pitch) < 0.5 * core_length;
    for (int j = 0; j < cells; ++j) {
      const double y = bottom + (j + 0.5) * dy;
      double column = 0.0;
      for (int k = 0; k < cells; ++k) {
        const double r = std::hypot(y - size.axis_offset, -0.5 * size.width + (k + 0.5) * dz);
        const bool in_bottom = design.bottom_silicone && y < 0.5 * design.body.bottom_layer;
        const double silicone = in_bottom ? design.bottom_silicone->density : design.body.density;
        column += beside_core && r > inner && r < outer ? core_density : silicone;
      }
      const double mass = column * dx * dy * dz;
      sum.mass += mass;
      sum.along += mass * x;
      sum.offset += mass * y;
      second += mass * (x * x + y * y);
    }
  }
  sum.along /= sum.mass;
  sum.offset /= sum.mass;
  sum.inertia = second - sum.mass * (sum.along * sum.along + sum.offset * sum.offset);
  return sum;
}

double worst_error(const Segment& segment, const Moments& sum) {
  return std::max({std::abs(segment.mass / sum.mass - 1.0), std::abs(segment.com_along / sum.along - 1.0),
                   std::abs(segment.com_offset / sum.offset - 1.0), std::abs(segment.inertia / sum.inertia - 1.0)});
}

TEST(Segments, AreTheDensitySummedOverAGrid) {
  const Design design = uneven_design();
  const Dimensions size = dimensions(design);
  const std::vector<Segment> parts = segments(design, size);
  for (int index = 0; index < 3; ++index) {
    const Segment& part = parts[static_cast<std::size_t>(index)];
    const double coarse = worst_error(part, summed(design, size, index, 30));
    const double fine = worst_error(part, summed(design, size, index, 240));
    // Cells cut by a round or a flat face err at random: of the order of the cell for a flat one, 1/240 of a part
    // whose density differs by up to 7 from the silicone's. Eight times finer must be clearly better.
    EXPECT_LT(fine, 8e-3) << index;
    EXPECT_LT(fine, 0.5 * coarse) << index;
  }
}

// A bottom layer as heavy as a metal shows what a silicone's few per cent would hide in the grid.
TEST(Segments, AreTheDensitySummedOverAGridWithABottomLayerOfItsOwn) {
  Design design = uneven_design();
  design.bottom_silicone = design.body;
  design.bottom_silicone->density = 5000.0;
  const Dimensions size = dimensions(design);
  const std::vector<Segment> parts = segments(design, size);
  for (int index = 0; index < 3; ++index) {
    const Segment& part = parts[static_cast<std::size_t>(index)];
    EXPECT_LT(worst_error(part, summed(design, size, index, 240)), 8e-3) << index;
    const double length = part.length + (index == 2 ? design.body.front_length : 0.0);
    EXPECT_NEAR(part.bottom_mass, 5000.0 * size.width * design.body.bottom_layer * length, 1e-12);
  }
  // Of the same silicone it is no layer.
  design.bottom_silicone->density = design.body.density;
  const std::vector<Segment> same = segments(design, size);
  design.bottom_silicone.reset();
  const std::vector<Segment> one = segments(design, size);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(same[i].mass, one[i].mass, 1e-15 * one[i].mass);
    EXPECT_NEAR(same[i].inertia, one[i].inertia, 1e-12 * one[i].inertia);
    EXPECT_NEAR(same[i].heat_capacity, one[i].heat_capacity, 1e-12 * one[i].heat_capacity);
  }
}

TEST(Segments, KeepTheirMassOnTheAxisInThePapersModel) {
  Design design = uneven_design();
  const Dimensions size = dimensions(design);
  const std::vector<Segment> rigid = segments(design, size);
  design.choices.masses = SegmentMass::on_axis_points;
  const std::vector<Segment> points = segments(design, size);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(points[i].mass, rigid[i].mass);
    EXPECT_EQ(points[i].com_along, rigid[i].com_along);
    EXPECT_EQ(points[i].com_offset, size.axis_offset);
    EXPECT_EQ(points[i].inertia, 0.0);
    EXPECT_GT(rigid[i].inertia, 0.0);
  }
}

TEST(Segments, ScaleWithTheirCalibrationAndKeepTheirShape) {
  Design design = uneven_design();
  const Dimensions size = dimensions(design);
  const std::vector<Segment> derived = segments(design, size);
  design.calibration.magnet_segment_mass = 1.07;
  design.calibration.coil_segment_mass = 0.93;
  design.calibration.tip_com = 1.11;
  const std::vector<Segment> scaled = segments(design, size);
  const double rounding = 1e-15;
  EXPECT_NEAR(scaled[1].mass, 1.07 * derived[1].mass, rounding);
  EXPECT_NEAR(scaled[0].mass, 0.93 * derived[0].mass, rounding);
  EXPECT_NEAR(scaled[2].mass, 0.93 * derived[2].mass, rounding);
  EXPECT_NEAR(scaled[2].inertia, 0.93 * derived[2].inertia, rounding);
  EXPECT_NEAR(scaled[2].com_along, 1.11 * derived[2].com_along, rounding);
  EXPECT_EQ(scaled[1].com_along, derived[1].com_along);
}

// Silicone of its box less the cores, at 1300 J/(kg K), and the cores' own: by hand for the magnet segment.
TEST(Segments, StoreTheHeatOfWhatTheyConsistOf) {
  const Design design = paper_geometry();
  const Segment magnet = segments(design, dimensions(design))[1];
  const double core = M_PI * 10e-3 * 10e-3 * 6e-3;
  const double silicone = 1130.0 * (22e-3 * 24e-3 * 7.2e-3 - core);
  EXPECT_NEAR(magnet.silicone_mass, silicone, 1e-12);
  EXPECT_NEAR(magnet.heat_capacity, silicone * 1300.0 + 7500.0 * core * 460.0, 1e-9);
}

// By hand for the coil at the tip: the ring less 450 turns of 0.36 mm over the enamel at a mean radius of 6.25 mm, of
// silicone. An independent audit has 1.4 g for it.
TEST(Segments, WeighWhatTheirCoilsArePottedWith) {
  Design design = paper_geometry();
  const Segment dry = segments(design, dimensions(design)).back();
  design.coil.filler = Filler::silicone;
  const Segment potted = segments(design, dimensions(design)).back();
  const double outer = dimensions(design).coil_outer_radius;
  const double length = dimensions(design).coil_length;
  const double ring = M_PI * (outer * outer - 3e-3 * 3e-3) * length;
  const double overall = winding_of(design).wire().insulated_diameter;
  const double wires = 450.0 * 0.25 * M_PI * overall * overall * M_PI * (outer + 3e-3);
  EXPECT_NEAR(potted.mass - dry.mass, 1130.0 * (ring - wires), 1e-9);
  EXPECT_NEAR(potted.mass - dry.mass, 1.4e-3, 0.15e-3);
  EXPECT_NEAR(potted.heat_capacity - dry.heat_capacity, 1300.0 * (potted.mass - dry.mass), 1e-9);
  design.coil.filler = Filler::air;
  EXPECT_EQ(segments(design, dimensions(design)).back().mass, dry.mass);
}

}  // namespace
}  // namespace coilwright::actuator
