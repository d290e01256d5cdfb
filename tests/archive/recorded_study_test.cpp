// Studies whose evaluations go through an archive: same bits, evaluated once.
#include "coilwright/archive/recorded_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "coilwright/sizing/search/pareto.hpp"
#include "coilwright/sizing/study/assumption_effects.hpp"
#include "coilwright/sizing/study/sweep.hpp"
#include "sizing/small_study.hpp"
#include "temporary_folder.hpp"

namespace coilwright::archive {
namespace {

using sizing::DesignProblem;
using sizing::Evaluation;
using sizing::Study;

class Recorded : public ::testing::Test {
 protected:
  // A run of a study through the archive of that name, which is made where it is not there.
  template <class Work>
  Counts run(const DesignProblem& problem, const std::string& name, const Work& work,
             std::vector<std::shared_ptr<const Reader>> others = {}) {
    const std::filesystem::path path = folder_.path() / name;
    RecordedStudy::Sources sources;
    if (std::filesystem::exists(path))
      sources.known = std::make_shared<const Reader>(path);
    else
      create(path, {.command = "pareto", .study = "small", .columns = columns_of(problem.study())});
    sources.others = std::move(others);
    sources.writer = std::make_shared<Writer>(path, 40, Writer::OnRefusal{});
    RecordedStudy recorded(problem, sources);
    work(recorded);
    sources.writer->flush();
    EXPECT_EQ(sources.writer->failure(), std::nullopt);
    return recorded.counts();
  }

  [[nodiscard]] std::shared_ptr<const Reader> reader(const std::string& name) const {
    return std::make_shared<const Reader>(folder_.path() / name);
  }

  coilwright::testing::TemporaryFolder folder_;
};

void sweep_all(RecordedStudy& recorded, const DesignProblem& problem, std::vector<Evaluation>& out) {
  const auto evaluate = [&](std::size_t index, std::span<const double> point) {
    return recorded.evaluate(point, index + 1);
  };
  (void)sizing::sweep(problem, {.threads = 2, .stop = {}, .evaluate = evaluate},
                      [&](const sizing::SweptDesign& design) { out.push_back(design.evaluation); });
}

TEST_F(Recorded, EvaluatesOnceAndAnswersWithTheSameBits) {
  const DesignProblem problem(sizing::testing::small_study());
  std::vector<Evaluation> direct, first, second;
  (void)sizing::sweep(problem, {.threads = 2},
                      [&](const sizing::SweptDesign& design) { direct.push_back(design.evaluation); });
  const Counts made = run(problem, "a", [&](RecordedStudy& recorded) { sweep_all(recorded, problem, first); });
  const Counts known = run(problem, "a", [&](RecordedStudy& recorded) { sweep_all(recorded, problem, second); });
  EXPECT_EQ(made.evaluated, problem.point_count());
  EXPECT_EQ(known.evaluated, 0U);
  EXPECT_EQ(known.answered, problem.point_count());
  EXPECT_EQ(first, direct);
  EXPECT_EQ(second, direct);
  EXPECT_EQ(known.best, made.best);
  EXPECT_EQ(reader("a")->size(), problem.point_count());
  EXPECT_EQ(reader("a")->count("number = 5 and status = 'ok'") + reader("a")->count("number = 5 and status != 'ok'"),
            1U);
}

TEST_F(Recorded, PointsComeBackFromTheirValues) {
  const Study study = sizing::testing::small_study();
  const DesignProblem problem(study);
  for (std::size_t i = 0; i < problem.point_count(); ++i) {
    const std::vector<double> point = problem.point(i);
    EXPECT_EQ(point_of(study, values_of(study, point)), point);
  }
  EXPECT_EQ(point_of(study, std::vector<Value>{std::string("C"), 0.7, 13.0, 27.0}), std::nullopt);
  EXPECT_EQ(point_of(study, std::vector<Value>{std::string("B"), 0.8, 13.0, 27.0}), std::nullopt);
  EXPECT_EQ(point_of(study, std::vector<Value>{std::string("B"), 0.7, 13.0, 29.0}), std::nullopt);
}

TEST_F(Recorded, ASearchGoesTheSameWayThroughHalfAnArchive) {
  Study study = sizing::testing::small_study();
  study.variables[1] = sizing::parameter_variable("gap_mm", sizing::Interval{.lower = 0.7, .upper = 1.3});
  const DesignProblem problem(study);
  const sizing::ParetoOptions options{.max_evaluations = 40, .seed = 3, .threads = 2};
  const sizing::ParetoResult undisturbed = sizing::pareto(problem.problem(), options);

  // Stopped in the middle, as a kill would.
  (void)run(problem, "a", [&](RecordedStudy& recorded) {
    std::stop_source stop;
    sizing::Problem half = recorded.problem();
    std::atomic<int> left{17};
    half.evaluate = [&, evaluate = half.evaluate](std::span<const double> point) {
      if (--left <= 0) stop.request_stop();
      return evaluate(point);
    };
    sizing::ParetoOptions stopped = options;
    stopped.stop = stop.get_token();
    (void)sizing::pareto(half, stopped);
  });
  const std::size_t recorded_before = reader("a")->size();
  EXPECT_GE(recorded_before, 17U);
  EXPECT_LT(recorded_before, 40U);
  const Counts counts = run(problem, "a", [&](RecordedStudy& recorded) {
    const sizing::ParetoResult resumed = sizing::pareto(recorded.problem(), options);
    EXPECT_EQ(resumed.archive.records(), undisturbed.archive.records());
    EXPECT_EQ(resumed.front, undisturbed.front);
    recorded.number(folder_.path() / "a", resumed.archive.records());
  });
  EXPECT_EQ(counts.answered, recorded_before);
  EXPECT_EQ(counts.evaluated, undisturbed.evaluations - recorded_before);
  EXPECT_EQ(reader("a")->count("number is not null"), undisturbed.evaluations);
}

TEST_F(Recorded, DesignsUnderAnotherChoiceAreAnsweredToo) {
  const DesignProblem problem(sizing::testing::small_study());
  const actuator::OtherChoice choice = actuator::other_choices(problem.study().base).front();
  const DesignProblem other = sizing::under(problem, choice);
  const std::vector<double> point = problem.point(0);
  std::vector<Evaluation> said;
  for (const std::size_t recorded_before : {0U, 1U}) {
    const Counts counts = run(problem, "a", [&](RecordedStudy& recorded) {
      said.push_back(recorded.evaluate_under(sizing::name_of(choice), other, point));
    });
    EXPECT_EQ(counts.evaluated + counts.answered, 0U);
    EXPECT_EQ(reader("a")->size(), 0U) << recorded_before;
  }
  EXPECT_EQ(said, std::vector(2, other.assess(other.evaluate(point))));
  const Row row = reader("a")->find(values_of(problem.study(), point), sizing::name_of(choice)).value();
  EXPECT_EQ(row.id, 1);
  EXPECT_EQ(row.run, 1) << "the second run recorded nothing";
  EXPECT_EQ(evaluated_again(problem, reader("a")->contents(), row), said[0]);
}

TEST_F(Recorded, AnotherStudyIsAnsweredFromTheQuantities) {
  const DesignProblem swept(sizing::testing::small_study());
  std::vector<Evaluation> ignored;
  (void)run(swept, "sweep", [&](RecordedStudy& recorded) { sweep_all(recorded, swept, ignored); });

  Study other = sizing::testing::small_study();
  std::swap(other.variables[0], other.variables[2]);
  other.objectives = {{.quantity = sizing::testing::quantity("cost_USD"), .sense = sizing::Sense::minimise}};
  other.limits = {
      {.quantity = sizing::testing::quantity("steady_angle_deg"), .side = sizing::Limit::Side::at_most, .value = 40}};
  std::get<sizing::ParameterVariable>(other.variables[1]).range =
      sizing::Interval{.lower = 0.7, .upper = 1.3, .step = 0.2};  // one more value
  const DesignProblem problem(other);
  std::vector<Evaluation> direct, answered;
  (void)sizing::sweep(problem, {.threads = 1},
                      [&](const sizing::SweptDesign& design) { direct.push_back(design.evaluation); });
  const Counts counts = run(problem, "other", [&](RecordedStudy& recorded) { sweep_all(recorded, problem, answered); },
                            {reader("sweep")});
  EXPECT_EQ(answered, direct);
  EXPECT_EQ(counts.reused, swept.point_count());
  EXPECT_EQ(counts.evaluated, problem.point_count() - swept.point_count());
  EXPECT_EQ(reader("other")->row(1)->origin.empty(), reader("other")->row(1)->seconds.has_value());
}

TEST_F(Recorded, AForgedNumberIsFound) {
  const DesignProblem problem(sizing::testing::small_study());
  std::vector<Evaluation> ignored;
  (void)run(problem, "a", [&](RecordedStudy& recorded) { sweep_all(recorded, problem, ignored); });
  const auto differing = [&](const std::string& name, std::size_t count) {
    const auto archive = reader(name);
    return designs_with_other_numbers(problem, archive->contents(), archive->sample(count, "1"));
  };
  EXPECT_THAT(differing("a", 3), ::testing::IsEmpty());
  const std::filesystem::path forged = folder_.path() / "b";
  create(forged, {.command = "pareto", .study = "small", .columns = columns_of(problem.study())});
  {
    Writer writer(forged, 40, {});
    for (std::int64_t id = 1; id <= 3; ++id) {
      Row row = reader("a")->row(id).value();
      if (id == 3) row.evaluation.quantities.at(0) = row.evaluation.quantities.at(0).value_or(0) + 1e-9;
      writer.add(row);
    }
  }
  EXPECT_THAT(differing("b", 3), ::testing::ElementsAre(3));
  EXPECT_THAT(differing("b", 1), ::testing::IsEmpty());
  EXPECT_EQ(evaluated_again(problem, reader("b")->contents(), *reader("b")->row(3)), reader("a")->row(3)->evaluation);
}

}  // namespace
}  // namespace coilwright::archive
