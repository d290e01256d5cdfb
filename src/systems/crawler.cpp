#include "coilwright/systems/crawler.hpp"

#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

#include "coilwright/actuator/design/current_shares.hpp"
#include "systems/check.hpp"

namespace coilwright::systems {
namespace {

using mechanics::Link;

void check(const CrawlerParts& parts) {
  const auto positive = [](double value, const char* field) { require(value > 0.0, field, "finite and > 0", value); };
  positive(parts.payload.mass, "payload.mass");
  positive(parts.payload.length, "payload.length");
  positive(parts.cell.voltage, "cell.voltage");
  positive(parts.cell.capacity, "cell.capacity");
  positive(parts.cell.current_limit, "cell.current_limit");
  positive(parts.friction.forwards, "friction.forwards");
  positive(parts.friction.backwards, "friction.backwards");
  positive(parts.drive.frequency, "drive.frequency");
  require(parts.drive.duty > 0.0 && parts.drive.duty < 1.0, "drive.duty", "> 0 and < 1", parts.drive.duty);
  require(parts.drive.lead_resistance >= 0.0, "drive.lead_resistance", "finite and >= 0", parts.drive.lead_resistance);
}

// The base with the payload behind it: a uniform box of the body's height. Its own joint is the new rear end.
Link laden_base(const actuator::Design& design, const actuator::Assembly& assembly, const Payload& payload) {
  const actuator::Segment& base = assembly.segments.front();
  const double height = assembly.dimensions.height;
  const double box_along = 0.5 * payload.length;
  const double box_offset = 0.5 * (height - design.body.bottom_layer);
  const double box_inertia = payload.mass * (height * height + payload.length * payload.length) / 12.0;
  const double base_along = payload.length + base.com_along;
  Link out{.length = payload.length + base.length, .mass = payload.mass + base.mass};
  out.com_along = (payload.mass * box_along + base.mass * base_along) / out.mass;
  out.com_offset = (payload.mass * box_offset + base.mass * base.com_offset) / out.mass;
  const double along = base_along - box_along;
  const double offset = base.com_offset - box_offset;
  out.inertia = box_inertia + base.inertia + payload.mass * base.mass / out.mass * (along * along + offset * offset);
  return out;
}

mechanics::FloatingChain chain_of(const actuator::Design& design, const actuator::Assembly& assembly,
                                  const Payload& payload) {
  std::vector<Link> links{laden_base(design, assembly, payload)};
  for (const Link& link : assembly.model.chain().links()) links.push_back(link);
  return mechanics::FloatingChain(links, assembly.model.chain().gravity());
}

double current_of_pulse(int coils, double resistance, const CrawlerParts& parts) {
  return parts.cell.voltage / (resistance + coils * parts.drive.lead_resistance);
}

}  // namespace

Crawler::Crawler(const actuator::Design& design, const actuator::Assembly& assembly, const CrawlerParts& parts)
    : parts_((check(parts), parts)),
      model_(assembly.model),
      chain_(chain_of(design, assembly, parts.payload)),
      coil_resistance_(assembly.coil.resistance),
      bottom_(0.5 * design.body.bottom_layer) {
  if (model_.coils() == 0) throw std::invalid_argument("crawler: the actuator must have coils; got 0");
  if (model_.has_terms())
    throw std::invalid_argument(fmt::format("crawler: the actuator must have no effects that act while it runs; got {}",
                                            model_.nominal_spec().effects.size()));
  require_one_current(design, "a cell through one switch");
  const double current = model_.coils() * pulse_current();
  if (current > parts_.cell.current_limit)
    throw std::invalid_argument(
        fmt::format("cell: the current of a pulse, {:.4g} A through {} coils, must not exceed its limit of {:.4g} A",
                    current, model_.coils(), parts_.cell.current_limit));
  points_.push_back({.link = 0, .along = 0.0, .offset = -bottom_});
  for (int j = 0; j < chain_.joints(); ++j)
    points_.push_back({.link = j, .along = chain_.link(j).length, .offset = -bottom_});
  points_.push_back({.link = chain_.joints(), .along = assembly.dimensions.tip_length, .offset = -bottom_});
}

mechanics::CoordinateVector Crawler::lying() const {
  mechanics::CoordinateVector out = mechanics::CoordinateVector::Zero(chain_.coordinates());
  out[1] = bottom_;
  out[2] = -0.5 * std::numbers::pi;
  return out;
}

double Crawler::pulse_current() const noexcept {
  return current_of_pulse(model_.coils(), coil_resistance_, parts_);
}

double pulse_current(const actuator::Assembly& assembly, const CrawlerParts& parts) {
  return assembly.coils == 0 ? 0.0 : current_of_pulse(assembly.coils, assembly.coil.resistance, parts);
}

}  // namespace coilwright::systems
