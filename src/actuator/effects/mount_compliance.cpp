#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/effects/effect_rows.hpp"

namespace coilwright::actuator::effects {
namespace {

// Of the mount by itself, with the finger held stiff on it: clamped metal and printed parts have 1 to 10 %.
constexpr double usual_damping_ratio = 0.05;

// A link's share of the momentum across the straight chain is its absolute rate times (A cos phi + O sin phi).
struct LinkMoments {
  double along{};   // A: length times the mass beyond, and mass times com_along, kg m
  double offset{};  // O: mass times com_offset, kg m
};

// One body: the mount's displacement X, m, across the straight chain, towards opening. All links ride on it, so they
// couple to it by their momentum and its own mass is that of mount and chain together. Joint angles are relative: the
// camera does not see X itself, only what it does to the joints.
class MountTerm final : public EffectTerm {
 public:
  struct Spec {
    double frequency{};   // rad/s
    double mass_ratio{};  // chain over mount
    double damping_ratio{};
  };
  MountTerm(const mechanics::PlanarChain& chain, const Spec& spec)
      : frequency_(spec.frequency), damping_ratio_(spec.damping_ratio) {
    double beyond = 0.0;
    moments_.resize(static_cast<std::size_t>(chain.joints()));
    for (int j = chain.joints() - 1; j >= 0; --j) {
      const mechanics::Link& link = chain.link(j);
      moments_[static_cast<std::size_t>(j)] = {.along = link.length * beyond + link.mass * link.com_along,
                                               .offset = link.mass * link.com_offset};
      beyond += link.mass;
    }
    mass_ = beyond * (1.0 + 1.0 / spec.mass_ratio);
  }

  int states() const override { return 2; }
  int bodies() const override { return 1; }

  void describe_bodies(const Kinematics& motion, const CoilCurrents& /*strength*/, const double* states,
                       Body* out) const override {
    double angle = 0.0;
    double rate = 0.0;
    double thrown = 0.0;  // what the links' rates alone change of the momentum, N
    for (int j = 0; j < motion.angles.size(); ++j) {
      const LinkMoments& link = moments_[static_cast<std::size_t>(j)];
      angle += motion.angles[j];
      rate += motion.rates[j];
      const double sine = std::sin(angle);
      const double cosine = std::cos(angle);
      // Joint j turns link j and all beyond it.
      out->coupling.head(j + 1).array() += link.along * cosine + link.offset * sine;
      thrown += rate * rate * (link.offset * cosine - link.along * sine);
    }
    out->mass = mass_;
    out->force = -mass_ * frequency_ * (frequency_ * states[0] + 2.0 * damping_ratio_ * states[1]) - thrown;
  }

 private:
  std::vector<LinkMoments> moments_;
  double mass_{};  // of mount and chain, kg
  double frequency_;
  double damping_ratio_;
};

constexpr EffectParameter frequency{.key = "frequency_Hz",
                                    .text = "of the mount on its spring, with the finger held stiff",
                                    .lower = 5.0,
                                    .upper = 300.0};
constexpr EffectParameter mass_ratio = from_zero("mass_ratio", "mass of the chain over that of the mount", 5.0);
constexpr EffectParameter damping_ratio{
    .key = "damping_ratio",
    .text = "of the mount on its spring, with the finger held stiff; 0.05 if not given",
    .lower = 0.001,
    .upper = 0.5};

constexpr double slowest_start = 6.0;  // Hz

// The fastest mount that a fit starts from, Hz: the records still show three samples of its period.
double fastest_start(const RigScale& scale) {
  return std::clamp(0.3 / scale.interval, 12.0, 150.0);
}

// What the mount has with the usual damping and with one of its own.
EffectProperties mount() {
  return {
      .id = "mount_compliance",
      .stage = Stage::chain,
      .description = "the mount gives way: a mass on a spring that moves with the finger",
      .equation =
          "M theta'' + p X'' = q, p . theta'' + (m/mu + m) (X'' + 2 zeta w X' + w^2 X) + p' . theta' = 0, zeta = 0.05 "
          "unless given, p = d(momentum)/d(rates), m of the chain",
      .source =
          "Lagrange's equations of a chain on a sliding base (Goldstein, Classical Mechanics, ch. 1); damping a choice",
      .check = "repeat one step with the mount clamped hard, or tap it and film whether it moves",
      .build = [](Values values, ModelSpec& spec) -> Term {
        if (!(values[1] > 1e-9)) return nullptr;  // a mount a thousand million times as heavy
        return std::make_unique<MountTerm>(
            spec.chain, MountTerm::Spec{.frequency = 2.0 * std::numbers::pi * values[0],
                                        .mass_ratio = values[1],
                                        .damping_ratio = values.size() > 2 ? values[2] : usual_damping_ratio});
      }};
}

// The damping told by the records: a mount that rings for longer than the usual one, or not at all.
EffectProperties damped_mount() {
  EffectProperties row = mount();
  row.parameters = {frequency, mass_ratio, damping_ratio};
  row.starts = [](const RigScale& scale) {
    const double fastest = fastest_start(scale);
    return Starts{{fastest, 0.2, 0.02}, {fastest, 0.2, 0.15}};
  };
  return row;
}

}  // namespace

EffectProperties mount_compliance() {
  EffectProperties row = mount();
  row.parameters = {frequency, mass_ratio};
  row.further = &kind_of<damped_mount>();
  row.starts = [](const RigScale& scale) {
    const double fastest = fastest_start(scale);
    // A heavy mount rings by itself: a start must be near enough that both keep step for a few swings.
    constexpr double widest_ratio = 1.4;
    const int count = 1 + static_cast<int>(std::ceil(std::log(fastest / slowest_start) / std::log(widest_ratio)));
    return each_with_each(log_spread(slowest_start, fastest, count), {0.05, 0.2});
  };
  return row;
}

}  // namespace coilwright::actuator::effects
