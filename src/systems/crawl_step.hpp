#pragma once

#include "coilwright/mechanics/moreau_step.hpp"
#include "coilwright/systems/crawler.hpp"

namespace coilwright::systems {

/// Whether the cell is on the coils.
enum class Switch { open, closed };

/// What passes in one step or many, J and C.
struct CrawlWork {
  double charge{};
  double electrical{};
  double copper{};
  double leads{};
  double mechanical{};
  double hinges{};
  double friction{};
  double impacts{};
};

/// Where a robot is and how it moves.
struct CrawlState {
  mechanics::CoordinateVector position;
  mechanics::CoordinateVector velocity;
};

/// Takes one step of `duration`, s, in halves where a foot lands too fast in it, and adds what passes to `work`.
[[nodiscard]] CrawlState advance(const Crawler& crawler, CrawlState state, Switch position, double duration,
                                 CrawlWork& work);

/// Kinetic, potential and elastic energy, J.
[[nodiscard]] double stored_energy(const Crawler& crawler, const CrawlState& state);

}  // namespace coilwright::systems
