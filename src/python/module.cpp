#include <pybind11/pybind11.h>

#include <glog/logging.h>

#include "python/bindings.hpp"

PYBIND11_MODULE(_core, module) {
  using namespace coilwright::python;
  // Ceres tells standard error of every fit that it gives up; a hypothesis that cannot be simulated is no news.
  FLAGS_minloglevel = google::GLOG_FATAL;
  module.attr("version") = COILWRIGHT_VERSION;
  bind_errors(module);
  bind_effects(module);
  bind_actuator(module);
  bind_performance(module);
  bind_motion(module);
  bind_force(module);
  bind_study(module);
  bind_problem(module);
  bind_answers(module);
  bind_diagnosis(module);
  bind_systems(module);
  bind_films(module);
}
