#include "coilwright/systems/crawler.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "coilwright/systems/crawl.hpp"
#include "coilwright/systems/validation/paper_finger.hpp"
#include "error_text.hpp"

namespace coilwright::systems {
namespace {

CrawlerParts parts(double forwards = 0.3, double backwards = 0.6) {
  CrawlerParts out;
  out.friction = {forwards, backwards};
  return out;
}

Crawler robot(const CrawlerParts& of) {
  const actuator::Design design = validation::paper_finger();
  return Crawler(design, actuator::assemble_or_throw(design), of);
}

TEST(Crawler, IsThePapersInMassCurrentAndPower) {
  const Crawler crawler = robot(parts());
  EXPECT_NEAR(crawler.mass(), 0.091, 1e-3);  // two digits printed, and a finger of 68 g that is 68.5 here
  EXPECT_NEAR(crawler.pulse_current(), 1.05, 0.005);
  // 4.2 V, 1.05 A and two coils at half of the time are 4.41 W; what motion induces takes 2 % off here.
  EXPECT_NEAR(crawl(crawler).powers.electrical, 4.41, 0.03 * 4.41);
}

TEST(Crawler, LiesOnAllOfItsContactPoints) {
  const Crawler crawler = robot(parts());
  const mechanics::FloatingFrames frames = crawler.chain().frames(crawler.lying());
  ASSERT_EQ(crawler.contact_points().size(), 4U);
  double before = 1.0;
  for (const mechanics::LinkPoint& point : crawler.contact_points()) {
    const Eigen::Vector2d at = crawler.chain().position(frames, point);
    EXPECT_NEAR(at.y(), 0.0, 1e-17);
    EXPECT_LT(at.x(), before);  // rear end first, front end at the smallest x
    before = at.x();
  }
  // 30 mm of payload, 20 mm of rear part, 41 mm of finger
  EXPECT_NEAR(before, -0.091, 1e-4);
}

TEST(Crawl, ConvergesInItsStep) {
  const Crawler crawler = robot(parts());
  const auto at = [&](double step) { return crawl(crawler, {.settling_periods = 4, .periods = 10, .step = step}); };
  const Crawl fine = at(2.5e-5);
  EXPECT_GT(fine.speed, 0.03);
  // A foot that lands is late by up to a step of a period of 100 ms: some 1e-3 at 1e-4 s.
  for (const double step : {4e-4, 1e-4}) {
    const Crawl coarse = at(step);
    EXPECT_NEAR(coarse.speed, fine.speed, 20.0 * step * fine.speed) << step;
    EXPECT_NEAR(coarse.largest_bending, fine.largest_bending, 50.0 * step * fine.largest_bending) << step;
  }
}

// Where feet land hard, a step that finds them deep in the ground cost 2.4 % of the speed.
TEST(Crawl, LandsAtTheDefaultStepAsWithAFineOne) {
  CrawlerParts of = parts(0.2, 0.8);
  of.drive.frequency = 8.0;
  const Crawler crawler = robot(of);
  const double fine = crawl(crawler, {.step = 1e-5}).speed;
  EXPECT_NEAR(crawl(crawler, {.step = 1e-4}).speed, fine, 5e-3 * fine);
}

TEST(Crawl, BalancesItsBookOfEnergy) {
  const Crawler crawler = robot(parts());
  for (const double step : {2e-4, 5e-5}) {
    const CrawlPowers powers = crawl(crawler, {.settling_periods = 4, .periods = 10, .step = step}).powers;
    EXPECT_NEAR(powers.electrical, powers.copper + powers.leads + powers.mechanical, 1e-12);
    for (const double loss : {powers.copper, powers.leads, powers.hinges, powers.friction, powers.impacts})
      EXPECT_GT(loss, 0.0);
    // The mass matrix is that of the step's middle: the energy of a turning body errs with the step.
    EXPECT_LT(std::abs(powers.unbalanced), 10.0 * step * powers.mechanical) << step;
  }
}

// Where both directions have the same friction the robot still moves, because it is heavier behind; with the directions
// exchanged it must lose by what it had won.
TEST(Crawl, GoesWhereItsFeetGlide) {
  const double with = crawl(robot(parts(0.3, 0.6))).speed;
  const double equal = crawl(robot(parts(0.45, 0.45))).speed;
  const double against = crawl(robot(parts(0.6, 0.3))).speed;
  EXPECT_GT(with, equal + 0.01);
  EXPECT_LT(against, equal - 0.01);
}

// Robots that lie almost flat for long, whose feet slide almost alike: Lemke's method alone had ended in these runs
// with 2e-8 of the speed left over. In the last one it finds once, of feet that land in one line, that nothing presses.
TEST(Crawl, GoesOnThroughLongRests) {
  struct Run {
    double forwards, backwards, frequency, duty, step;
  };
  for (const Run& run :
       {Run{0.6, 0.06202359173306569, 10.0, 0.2, 1e-4}, Run{0.0809832, 0.685948, 4.03861, 0.149811, 3e-4},
        Run{0.121453, 0.362649, 3.03615, 0.225927, 3e-4}, Run{0.3, 0.3, 8.0, 0.5, 1e-5}}) {
    CrawlerParts of = parts(run.forwards, run.backwards);
    of.drive.frequency = run.frequency;
    of.drive.duty = run.duty;
    EXPECT_NO_THROW((void)crawl(robot(of), {.step = run.step})) << run.frequency;
  }
}

TEST(Crawl, GivesDistanceAndRunTimeOfACharge) {
  const Crawl result = crawl(robot(parts()));
  EXPECT_DOUBLE_EQ(result.run_time, 0.15 * 3600.0 / result.mean_current);
  EXPECT_DOUBLE_EQ(result.distance_per_charge, result.speed * result.run_time);
  EXPECT_NEAR(result.mean_current * 4.2, result.powers.electrical, 1e-12);
}

TEST(Crawler, RefusesWhatCannotCrawl) {
  const auto refuse = [](const std::function<void(CrawlerParts&)>& change, const std::string& text) {
    CrawlerParts of = parts();
    change(of);
    EXPECT_EQ(error_text([&] { (void)robot(of); }), text);
  };
  refuse([](CrawlerParts& of) { of.friction.forwards = 0.0; }, "friction.forwards must be finite and > 0; got 0");
  refuse([](CrawlerParts& of) { of.friction.backwards = std::nan(""); },
         "friction.backwards must be finite and > 0; got nan");
  refuse([](CrawlerParts& of) { of.drive.frequency = 0.0; }, "drive.frequency must be finite and > 0; got 0");
  refuse([](CrawlerParts& of) { of.drive.duty = 1.0; }, "drive.duty must be > 0 and < 1; got 1");
  refuse([](CrawlerParts& of) { of.payload.mass = -0.02; }, "payload.mass must be finite and > 0; got -0.02");
  refuse([](CrawlerParts& of) { of.cell.current_limit = 1.5; },
         "cell: the current of a pulse, 2.099 A through 2 coils, must not exceed its limit of 1.5 A");
  EXPECT_EQ(error_text([] { (void)crawl(robot(parts()), {.settling_periods = 1, .periods = 0}); }),
            "periods must be >= 1; got 0");
}

}  // namespace
}  // namespace coilwright::systems
