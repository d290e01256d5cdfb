#include "systems/crawl_step.hpp"

#include "systems/hinge_slopes.hpp"

namespace coilwright::systems {
namespace {

using actuator::CoilCurrents;
using mechanics::CoordinateMatrix;
using mechanics::CoordinateVector;
using mechanics::JointMatrix;
using mechanics::JointVector;

// Torque of every joint per ampere of every coil, (joints, coils), N m/A, and so the voltage that a joint's rate
// induces in a coil, V s: the same curve, so that what the coils put into the chain is what they take from the cell.
using Coupling = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mechanics::max_joints,
                               mechanics::max_joints + 1>;

Coupling coupling_of(const actuator::Model& model, const JointVector& angles) {
  JointVector without = JointVector::Zero(model.joints());
  CoilCurrents currents = model.all_coils(0.0);
  model.magnetics().add_torques(model.chain(), angles, currents, without);
  Coupling out(model.joints(), model.coils());
  for (int c = 0; c < model.coils(); ++c) {
    JointVector torque = JointVector::Zero(model.joints());
    currents[c] = 1.0;
    model.magnetics().add_torques(model.chain(), angles, currents, torque);
    currents[c] = 0.0;
    out.col(c) = torque - without;
  }
  return out;
}

// Coils of R in parallel behind a common r: R I_c + r sum I = U_c, solved for I.
CoilCurrents currents_by(const Crawler& crawler, const CoilCurrents& voltages) {
  const double own = crawler.coil_resistance();
  const double leads = crawler.parts().drive.lead_resistance;
  const double shared = leads * voltages.sum() / (own + static_cast<double>(voltages.size()) * leads);
  return (voltages.array() - shared).matrix() / own;
}

// No foot of a robot comes down faster, m/s: what is too high to land in a step at that speed need not be looked at.
constexpr double fastest_landing = 10.0;

// What the middle of a step knows that its end needs again.
struct Middle {
  Coupling coupling;
  JointVector damping;
};

mechanics::MiddleOfStep at_middle(const Crawler& crawler, const CoordinateVector& position,
                                  const CoordinateVector& velocity, Switch state, double step, Middle& keep) {
  const actuator::Model& model = crawler.model();
  const mechanics::FloatingChain& chain = crawler.chain();
  const int n = model.joints();
  const JointVector angles = position.tail(n);
  const JointVector rates = velocity.tail(n);
  const mechanics::FloatingFrames frames = chain.frames(position);

  mechanics::MiddleOfStep out{
      .mass = chain.mass_matrix(frames), .force = -chain.bias_forces(frames, velocity), .contacts = {}};
  CoilCurrents currents = model.all_coils(0.0);
  JointMatrix implicit = JointMatrix::Zero(n, n);
  if (state == Switch::closed) {
    keep.coupling = coupling_of(model, angles);
    const CoilCurrents supply = model.all_coils(crawler.parts().cell.voltage);
    currents = currents_by(crawler, supply - keep.coupling.transpose() * rates);
    for (int j = 0; j < n; ++j)
      implicit.col(j) = 0.5 * step * keep.coupling * currents_by(crawler, keep.coupling.row(j).transpose());
  }
  out.force.tail(n) += model.torques(angles, rates, currents);
  const HingeSlopes hinges = hinge_slopes(model, angles, rates);
  keep.damping = hinges.damping;
  implicit.diagonal() += hinges.implicit_inertia(step);
  out.mass.bottomRightCorner(n, n) += implicit;

  const FootFriction& friction = crawler.parts().friction;
  out.contacts.reserve(crawler.contact_points().size());
  for (const mechanics::LinkPoint& point : crawler.contact_points()) {
    const double gap = chain.position(frames, point).y();
    if (gap > 0.5 * fastest_landing * step) continue;
    const mechanics::FloatingJacobian slope = chain.jacobian(frames, point);
    out.lands = out.lands || mechanics::lands_too_fast(gap, -slope.row(1).dot(velocity), step);
    if (gap > mechanics::closed_gap) continue;
    out.contacts.push_back({.normal = slope.row(1).transpose(),
                            .tangent = -slope.row(0).transpose(),
                            .friction = {.along = friction.forwards, .against = friction.backwards}});
  }
  return out;
}

void add_electrical(const Crawler& crawler, const Coupling& coupling, const JointVector& rates, double step,
                    CrawlWork& work) {
  const double voltage = crawler.parts().cell.voltage;
  const CoilCurrents induced = coupling.transpose() * rates;
  const CoilCurrents currents = currents_by(crawler, crawler.model().all_coils(voltage) - induced);
  const double current = currents.sum();
  work.charge += step * current;
  work.electrical += step * voltage * current;
  work.copper += step * crawler.coil_resistance() * currents.squaredNorm();
  work.leads += step * crawler.parts().drive.lead_resistance * current * current;
  work.mechanical += step * currents.dot(induced);
}

}  // namespace

CrawlState advance(const Crawler& crawler, CrawlState state, Switch position, double duration, CrawlWork& work) {
  Middle middle;
  mechanics::advance_to_landings(
      state.position, state.velocity, duration,
      [&](const CoordinateVector& at, const CoordinateVector& moving, double part) {
        return at_middle(crawler, at, moving, position, part, middle);
      },
      [&](const mechanics::MoreauStep& step, double part) {
        const JointVector rates = step.middle_velocity.tail(crawler.model().joints());
        if (position == Switch::closed) add_electrical(crawler, middle.coupling, rates, part, work);
        work.hinges += part * middle.damping.dot(rates.cwiseProduct(rates));
        for (std::size_t i = 0; i < step.contacts.size(); ++i) {
          work.friction -= step.impulses[i].tangential * step.contacts[i].tangent.dot(step.middle_velocity);
          work.impacts -= step.impulses[i].normal * step.contacts[i].normal.dot(step.middle_velocity);
        }
      });
  return state;
}

double stored_energy(const Crawler& crawler, const CrawlState& state) {
  const mechanics::FloatingFrames frames = crawler.chain().frames(state.position);
  double energy = crawler.chain().kinetic_energy(frames, state.velocity) + crawler.chain().potential_energy(frames);
  for (int j = 0; j < crawler.model().joints(); ++j) {
    const actuator::Hinge& hinge = crawler.model().hinges()[j];
    const double angle = state.position[3 + j];
    energy += 0.5 * hinge.stiffness * angle * angle - hinge.torque_offset * angle + hinge.contact.energy(angle);
  }
  return energy;
}

}  // namespace coilwright::systems
