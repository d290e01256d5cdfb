#pragma once

#include <string>
#include <vector>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/systems/rig/per_fidelity.hpp"

namespace coilwright::systems::rig {

/// The paper's camera of Figs 10a and 12 to 14: the bending angle under steps and sines of the current in every coil.
/// The command is held from frame to frame.
struct Camera {
  double frame_rate = 2000.0;                               ///< Hz; finite, > 0
  std::vector<double> steps = {0.35, 0.7, 1.05, 1.4};       ///< A, each once; from rest without current, after 0.1 s
  double step_duration = 2.0;                               ///< of a record, s; finite, > 0.1
  std::vector<double> frequencies = {0.5, 1.0, 2.0, 10.0};  ///< of sines, Hz, each once; > 0, at most a tenth of the
                                                            ///< frame rate. A record has two periods and at least 1 s
  double amplitude = 0.7;                                   ///< of the sines, A: (23) of the paper; finite
  double offset = 0.7;                                      ///< of the sines, A; finite
};

/// Shape of the current of a record.
enum class CameraInput { step, sine };

/// One record as the camera would give it.
struct CameraRecord {
  CameraInput input{};
  double level{};                              ///< current after the step, A, or frequency of the sine, Hz
  std::vector<double> times{};                 ///< s, of the frames
  std::vector<double> currents{};              ///< A, in every coil
  PerFidelity<std::vector<double>> bending{};  ///< shown bending angle, rad

  /// The name of a record: "step_0.35A", "sine_10Hz".
  [[nodiscard]] std::string name() const;
};

/// Records of the steps, then of the sines, in their order. A sine starts at rest under its first current. Throws
/// std::invalid_argument naming field, rule and value, std::runtime_error if the actuator has no pose to start from or
/// its motion cannot be followed. Precondition: construction_faults(design) is empty.
[[nodiscard]] std::vector<CameraRecord> readings(const actuator::Design& design, const Camera& camera);

/// Figures that summarise a record, rad and s.
struct ResponseFigures {
  double first{};         ///< angle at the first frame
  double last{};          ///< angle at the last frame
  double largest{};       ///< of all frames
  double fastest{};       ///< largest rise from a frame to the next, rad/s
  double late_mean{};     ///< over the last period of a sine, over the last tenth of a step
  double peak_to_peak{};  ///< over the last period of a sine, over the last tenth of a step
};
/// Figures of the record by one fidelity.
[[nodiscard]] ResponseFigures figures(const CameraRecord& record, magnetics::Fidelity fidelity);

/// Mean absolute difference of the two fidelities over the frames, rad.
[[nodiscard]] double mean_difference(const CameraRecord& record);

}  // namespace coilwright::systems::rig
