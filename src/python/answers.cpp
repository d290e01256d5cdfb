#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "coilwright/formats/actuator/actuator_file.hpp"
#include "coilwright/formats/study/design_tables.hpp"
#include "coilwright/formats/study/front_json.hpp"
#include "coilwright/formats/study/result_files.hpp"
#include "coilwright/formats/study/study_file.hpp"
#include "coilwright/formats/study/sweep_json.hpp"
#include "coilwright/report/front_text.hpp"
#include "coilwright/report/size_text.hpp"
#include "coilwright/report/sweep_text.hpp"
#include "coilwright/sizing/study/leaders.hpp"
#include "coilwright/text/input_error.hpp"
#include "python/actuator.hpp"
#include "python/bindings.hpp"
#include "python/interruptible.hpp"
#include "python/json_objects.hpp"
#include "python/search_options.hpp"
#include "python/study.hpp"

namespace coilwright::python {
namespace {

namespace py = pybind11;
using sizing::DesignProblem;

sizing::Study study_with(const Study& study, const py::dict& words, bool answer_only,
                         const formats::ObjectiveCount& objectives) {
  formats::require_objectives(study.content, objectives, study.origin);
  sizing::Study out = study.content;
  out.search = options_of(words, out.search);
  if (answer_only) out.search.afterwards = sizing::Afterwards::nothing;
  return out;
}

std::string written(const std::function<void(std::ostream&)>& write) {
  std::ostringstream out;
  write(out);
  return out.str();
}

std::string evaluations_of(const DesignProblem& problem, const sizing::Archive& archive) {
  return written([&](std::ostream& out) { formats::write_evaluations(out, problem.study(), archive.records()); });
}

// Writes the files of an answer into a folder, all or none.
template <class Write>
void write_folder(const std::string& path, const Write& write) {
  const py::gil_scoped_release others_run;
  text::OutputFolder folder(path);
  write(folder);
  folder.commit("result.json");
}

Actuator actuator_at(const DesignProblem& problem, std::span<const double> point, const sizing::DesignResult& result,
                     const std::string& name) {
  const auto* evaluated = std::get_if<sizing::EvaluatedDesign>(&result);
  return actuator_of(problem.design_at(point), name,
                     evaluated != nullptr ? std::optional(evaluated->point) : std::nullopt);
}

// What `size` found.
class SizeAnswer {
 public:
  SizeAnswer(const DesignProblem& problem, sizing::SearchResult result, sizing::AfterSearch after)
      : problem_(problem), result_(std::move(result)), after_(std::move(after)) {}

  [[nodiscard]] bool feasible() const { return result_.feasible; }
  [[nodiscard]] formats::SizeReport report() const { return formats::size_report(problem_, result_, after_); }
  [[nodiscard]] report::Document document() const { return report::document_of(report()); }
  [[nodiscard]] text::Json json() const {
    return formats::to_json(report()).set("summary", report::to_json(document()));
  }
  [[nodiscard]] std::optional<std::string> best() const {
    if (!result_.best) return std::nullopt;
    return formats::found_design_text(problem_, result_, *after_.best);
  }
  [[nodiscard]] std::string evaluations() const { return evaluations_of(problem_, result_.archive); }
  void write(const std::string& path) const {
    write_folder(path, [&](text::OutputFolder& folder) {
      formats::write_size(folder, problem_, report(), report::to_json(document()));
    });
  }

 private:
  DesignProblem problem_;
  sizing::SearchResult result_;
  sizing::AfterSearch after_;
};

std::shared_ptr<SizeAnswer> size(const Study& study, const py::dict& words, bool answer_only) {
  const DesignProblem problem(study_with(study, words, answer_only, formats::objectives_of_size));
  return interruptible([&](const std::stop_token& stop) {
    sizing::SearchOptions search = problem.study().search;
    search.stop = stop;
    sizing::SearchResult result = sizing::search(problem.problem(), search);
    sizing::AfterSearch after =
        sizing::after_search(problem, result, {.builds = formats::builds_of_answer, .stop = stop});
    return std::make_shared<SizeAnswer>(problem, std::move(result), std::move(after));
  });
}

// What `pareto` found.
class Front {
 public:
  Front(const DesignProblem& problem, sizing::ParetoResult result) : problem_(problem), result_(std::move(result)) {
    designs_ = sizing::evaluated_again(problem_, std::span<const sizing::Record>(result_.front));
    broken_ = sizing::broken_part_limits(problem_.study(), designs_);
  }

  [[nodiscard]] text::Json json() const {
    return formats::to_json(problem_.study(), result_, broken_).set("summary", report::to_json(document()));
  }
  [[nodiscard]] report::Document document() const { return report::document_of(problem_.study(), result_, broken_); }
  [[nodiscard]] std::size_t size() const { return designs_.size(); }
  [[nodiscard]] Actuator actuator(std::size_t index) const {
    return actuator_at(problem_, result_.front.at(index).point, designs_.at(index), problem_.study().name);
  }
  [[nodiscard]] std::string table() const {
    return written([&](std::ostream& out) { formats::write_front(out, problem_.study(), result_.front); });
  }
  [[nodiscard]] std::string evaluations() const { return evaluations_of(problem_, result_.archive); }
  void write(const std::string& path) const {
    write_folder(path, [&](text::OutputFolder& folder) {
      formats::write_pareto(folder, problem_.study(), result_, broken_, report::to_json(document()));
    });
  }

 private:
  DesignProblem problem_;
  sizing::ParetoResult result_;
  std::vector<sizing::DesignResult> designs_;
  std::vector<sizing::BrokenPartLimit> broken_;
};

std::shared_ptr<Front> pareto(const Study& study, const py::dict& words) {
  const DesignProblem problem(study_with(study, words, true, formats::objectives_of_pareto));
  return interruptible([&](const std::stop_token& stop) {
    sizing::SearchOptions search = problem.study().search;
    search.stop = stop;
    sizing::ParetoResult result = sizing::pareto(problem.problem(), search);
    return std::make_shared<Front>(problem, std::move(result));
  });
}

// What `sweep` found: all of its designs, in memory.
class SweepAnswer {
 public:
  SweepAnswer(const DesignProblem& problem, std::optional<sizing::DesignSample> sample)
      : problem_(problem), sample_(sample), leaders_(problem_) {
    if (sample_) points_ = sizing::sampled_points(problem_, *sample_);
    count_ = sample_ ? points_.size() : problem_.point_count();
  }

  void run(const std::stop_token& stop) {
    sizing::sweep(problem_, {.threads = problem_.study().search.threads, .points = points_, .stop = stop},
                  [&](const sizing::SweptDesign& design) {
                    leaders_.consider(design);
                    ok_ += sizing::is_feasible(design.evaluation) ? 1 : 0;
                    designs_.push_back(design);
                  });
    best_ = leaders_.all();
    broken_ = sizing::broken_part_limits(problem_.study(),
                                         sizing::evaluated_again(problem_, sizing::feasible_designs(best_)));
  }
  [[nodiscard]] formats::SweepReport report() const {
    return {.study = problem_.study(),
            .designs = count_,
            .evaluated = designs_.size(),
            .ok = ok_,
            .leaders = best_,
            .broken = broken_,
            .sample = sample_};
  }
  [[nodiscard]] report::Document document() const { return report::document_of(report()); }
  [[nodiscard]] text::Json json() const {
    return formats::to_json(report()).set("summary", report::to_json(document()));
  }
  [[nodiscard]] std::size_t size() const { return designs_.size(); }
  [[nodiscard]] Actuator actuator(std::size_t index) const {
    const std::vector<double>& point = designs_.at(index).point;
    return actuator_at(problem_, point, problem_.evaluate(point), problem_.study().name);
  }
  void write_table(std::ostream& out) const {
    const formats::SweepRow row = formats::write_sweep(out, problem_.study());
    for (const sizing::SweptDesign& each : designs_) row(each);
  }
  void write(const std::string& path) const {
    write_folder(path, [&](text::OutputFolder& folder) {
      write_table(folder.open("designs.csv"));
      formats::write_leaders(folder.open("best.csv"), problem_.study(), best_);
      folder.write("result.json", json().text());
    });
  }

 private:
  DesignProblem problem_;
  std::optional<sizing::DesignSample> sample_;
  sizing::Leaders leaders_;
  std::vector<std::vector<double>> points_{};
  std::size_t count_{}, ok_{};
  std::vector<sizing::SweptDesign> designs_{};
  std::vector<sizing::Leader> best_{};
  std::vector<sizing::BrokenPartLimit> broken_{};
};

std::shared_ptr<SweepAnswer> sweep(const Study& study, const py::dict& words, std::size_t sample,
                                   bool latin_hypercube) {
  const DesignProblem problem(study_with(study, words, true, formats::objectives_of_sweep));
  std::optional<sizing::DesignSample> drawn;
  if (sample > 0)
    drawn = {.sampling = latin_hypercube ? sizing::Sampling::latin_hypercube : sizing::Sampling::random,
             .drawn = sample,
             .seed = problem.study().search.seed};
  auto answer = std::make_shared<SweepAnswer>(problem, drawn);
  return interruptible([&](const std::stop_token& stop) {
    answer->run(stop);
    return answer;
  });
}

}  // namespace

void bind_answers(py::module_& module) {
  py::class_<SizeAnswer, std::shared_ptr<SizeAnswer>>(module, "SizeAnswer")
      .def_property_readonly("feasible", &SizeAnswer::feasible)
      .def_property_readonly("text", [](const SizeAnswer& self) { return report::to_text(self.document()); })
      .def_property_readonly("html", [](const SizeAnswer& self) { return report::to_html(self.document()); })
      .def("to_dict", [](const SizeAnswer& self) { return to_python(self.json()); })
      .def("best", &SizeAnswer::best)
      .def("evaluations", &SizeAnswer::evaluations)
      .def("write", &SizeAnswer::write, py::arg("folder"));
  py::class_<Front, std::shared_ptr<Front>>(module, "Front")
      .def_property_readonly("text", [](const Front& self) { return report::to_text(self.document()); })
      .def_property_readonly("html", [](const Front& self) { return report::to_html(self.document()); })
      .def("to_dict", [](const Front& self) { return to_python(self.json()); })
      .def("__len__", &Front::size)
      .def("actuator", &Front::actuator, py::arg("index"))
      .def("table", &Front::table)
      .def("evaluations", &Front::evaluations)
      .def("write", &Front::write, py::arg("folder"));
  py::class_<SweepAnswer, std::shared_ptr<SweepAnswer>>(module, "SweepAnswer")
      .def_property_readonly("text", [](const SweepAnswer& self) { return report::to_text(self.document()); })
      .def_property_readonly("html", [](const SweepAnswer& self) { return report::to_html(self.document()); })
      .def("to_dict", [](const SweepAnswer& self) { return to_python(self.json()); })
      .def("__len__", &SweepAnswer::size)
      .def("actuator", &SweepAnswer::actuator, py::arg("index"))
      .def("table", [](const SweepAnswer& self) { return written([&](std::ostream& out) { self.write_table(out); }); })
      .def("write", &SweepAnswer::write, py::arg("folder"));
  module.def("size", &size, py::arg("study"), py::arg("words"), py::arg("answer_only"));
  module.def("pareto", &pareto, py::arg("study"), py::arg("words"));
  module.def("sweep", &sweep, py::arg("study"), py::arg("words"), py::arg("sample"), py::arg("latin_hypercube"));
}

}  // namespace coilwright::python
