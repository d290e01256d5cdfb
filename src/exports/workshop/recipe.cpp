#include "exports/workshop/recipe.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <sstream>

#include "coilwright/text/csv/csv_writer.hpp"
#include "coilwright/units/unit.hpp"
#include "exports/workshop/rounded.hpp"

namespace coilwright::exports {
namespace {

double wall_on(const BodyPlan& plan, actuator::ComponentKind kind) {
  for (const PlacedPart& part : plan.parts)
    if (part.component.kind == kind) return part.face_wall;
  return 0.0;
}

}  // namespace

Recipe recipe(const DesignSubject& subject, const ExportSettings& settings, const Cast& cast) {
  const actuator::BodyDesign& body = subject.design.body;
  const auto ratio_of = [](const actuator::SiliconeDesign& silicone) {
    return silicone.grade == nullptr ? 0.0 : silicone.grade->base_per_hardener;
  };
  const double ratio = settings.base_per_hardener > 0.0 ? settings.base_per_hardener : ratio_of(body);
  const auto batch = [&](std::string_view use, double in_actuator, double dip) {
    return Batch{.use = use,
                 .density = body.density,
                 .base_per_hardener = ratio,
                 .in_actuator = in_actuator,
                 .waste = settings.waste * in_actuator,
                 .dip = dip};
  };
  Recipe out{.segments = {},
             .batches = {batch("main body and first dip", cast.main_volume, cast.dip_volume),
                         batch("second dip", 0.0, cast.dip_volume),
                         batch("walls and bores and bond", cast.filling_volume, 0.0)},
             .coil_dip = wall_on(cast.plan, actuator::ComponentKind::coil),
             .magnet_dip = wall_on(cast.plan, actuator::ComponentKind::magnet)};
  for (std::size_t i = 0; i < subject.assembly.segments.size(); ++i)
    out.segments.push_back({.segment = static_cast<int>(i) + 1,
                            .kind = subject.design.layout[i].kind,
                            .volume = volume_of(subject.assembly.segments[i], subject.design),
                            .mass = subject.assembly.segments[i].silicone_mass});
  if (const auto& bottom = subject.design.bottom_silicone)
    out.batches.insert(out.batches.begin(), {.use = "bottom layer",
                                             .density = bottom->density,
                                             .base_per_hardener = ratio_of(*bottom),
                                             .in_actuator = cast.bottom_volume,
                                             .waste = settings.waste * cast.bottom_volume});
  return out;
}

std::string casting_csv(const Recipe& recipe) {
  std::ostringstream out;
  text::CsvWriter csv(out, {"what", "in_actuator_cm3", "waste_cm3", "dip_cm3", "mixed_cm3", "mixed_g"});
  const auto cm3 = [](double volume) { return rounded(1e6 * volume); };
  for (const Batch& batch : recipe.batches)
    csv.row({batch.use, cm3(batch.in_actuator), cm3(batch.waste), cm3(batch.dip), cm3(batch.mixed()),
             rounded(1e3 * batch.density * batch.mixed())});
  for (const SegmentSilicone& segment : recipe.segments) {
    const std::string what = fmt::format("segment {} ({})", segment.segment,
                                         segment.kind == actuator::ComponentKind::coil ? "coil" : "magnet");
    csv.row({what, cm3(segment.volume), {}, {}, {}, {}});
  }
  return out.str();
}

}  // namespace coilwright::exports
