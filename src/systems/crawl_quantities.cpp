#include "coilwright/systems/crawl_quantities.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "coilwright/systems/crawl_heat.hpp"
#include "coilwright/units/angle.hpp"
#include "systems/tried.hpp"

namespace coilwright::systems {
namespace {

using simulation::DesignView;
using simulation::NoValue;
using simulation::ResultQuantity;
using simulation::Settings;
using simulation::SharedResult;
using Value = std::optional<double>;
using TaskOf = std::function<CrawlTask(const Settings&)>;
// With the load of coils and magnets at its rms current.
struct Tried : Crawl {
  double thermal_load{};
};

// Current of all coils in a pulse over what the cell delivers.
double cell_load(const CrawlTask& task, const DesignView& design) {
  return design.assembly.coils * pulse_current(design.assembly, task.parts) / task.parts.cell.current_limit;
}

Try<Tried> try_crawl(const TaskOf& task_of, const DesignView& design) {
  const CrawlTask task = task_of(simulation::settings_of(design));
  return tried(
      [&]() -> Try<Tried> {
        const Crawler crawler(design.design, design.assembly, task.parts);
        Tried out{crawl(crawler, task.timing)};
        // Of all that heat_of_crawl() knows the search asks for one figure.
        const double for_good = lying_limits(design.design, design.assembly).for_good();
        if (for_good == 0.0)
          return NoValue{.reason = "the surroundings are as hot as a limit already", .infeasibility = 1.0};
        out.thermal_load = rms_current(crawler, out) / for_good;
        return out;
      },
      [&](const std::exception&) { return std::max(1.0, cell_load(task, design)); });
}

ResultQuantity of_crawl(const SharedResult<Try<Tried>>& result, std::string name, std::string meaning, double scale,
                        double (*value)(const Tried&)) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .scale = scale,
          .value = of_try(result, [value](const Tried& done, const DesignView&) { return value(done); }),
          .absence = "the robot cannot be tried on the ground",
          .pose = actuator::HeldCases::free,
          .why_absent = why_none(result)};
}

// What needs no steps on the ground.
ResultQuantity of_robot(const TaskOf& task, std::string name, std::string meaning, double scale,
                        double (*value)(const CrawlTask&, const DesignView&)) {
  return {.name = std::move(name),
          .meaning = std::move(meaning),
          .scale = scale,
          .value = [task, value](const DesignView& design) -> Value {
            return value(task(simulation::settings_of(design)), design);
          },
          .pose = actuator::HeldCases::free};
}

}  // namespace

std::vector<ResultQuantity> crawl_quantities(const TaskOf& task) {
  const SharedResult<Try<Tried>> result([task](const DesignView& design) { return try_crawl(task, design); });
  return {of_robot(task, "crawler_mass_g", "mass of the robot with its payload", 91.0,
                   [](const CrawlTask& t, const DesignView& d) {
                     return 1e3 * (d.performance.mass + t.parts.payload.mass);
                   }),
          of_robot(task, "crawler_friction_forwards", "coefficient of friction forwards that is assumed", 1.0,
                   [](const CrawlTask& t, const DesignView&) { return t.parts.friction.forwards; }),
          of_robot(task, "crawler_friction_backwards", "coefficient of friction backwards that is assumed", 1.0,
                   [](const CrawlTask& t, const DesignView&) { return t.parts.friction.backwards; }),
          of_robot(task, "crawl_coil_current_A", "current of one coil in a pulse while nothing moves, coils at 20 degC",
                   1.0, [](const CrawlTask& t, const DesignView& d) { return pulse_current(d.assembly, t.parts); }),
          of_robot(task, "crawl_cell_load", "current of all coils in a pulse over the most that the cell delivers", 1.0,
                   [](const CrawlTask& t, const DesignView& d) { return cell_load(t, d); }),
          of_crawl(result, "crawl_speed_mm_s", "mean speed towards the fingertip", 50.0,
                   [](const Tried& crawl) { return 1e3 * crawl.speed; }),
          of_crawl(result, "crawl_speed_scatter_mm_s", "standard deviation of the speeds of single periods", 5.0,
                   [](const Tried& crawl) { return 1e3 * crawl.speed_scatter; }),
          of_crawl(result, "crawl_mean_current_A", "mean current out of the cell", 1.0,
                   [](const Tried& crawl) { return crawl.mean_current; }),
          of_crawl(result, "crawl_power_W", "mean power out of the cell", 4.0,
                   [](const Tried& crawl) { return crawl.powers.electrical; }),
          simulation::of_every_use(
              of_crawl(result, "crawl_thermal_load",
                       "rms current over the smaller continuous current of coils and magnets, lying straight", 1.0,
                       [](const Tried& crawl) { return crawl.thermal_load; })),
          of_crawl(result, "crawl_run_time_s", "on one charge, at the cell's full voltage", 500.0,
                   [](const Tried& crawl) { return crawl.run_time; }),
          of_crawl(result, "crawl_distance_per_charge_m", "distance on one charge, at the cell's full voltage", 30.0,
                   [](const Tried& crawl) { return crawl.distance_per_charge; }),
          of_crawl(result, "crawl_largest_bending_deg", "largest bending angle on the ground", 30.0,
                   [](const Tried& crawl) { return crawl.largest_bending * units::degrees_per_radian; }),
          of_crawl(result, "crawl_smallest_bending_deg", "smallest bending angle on the ground", 10.0,
                   [](const Tried& crawl) { return crawl.smallest_bending * units::degrees_per_radian; })};
}

}  // namespace coilwright::systems
