#pragma once

#include <optional>
#include <string>
#include <vector>

#include "attribution/count.hpp"

namespace attribution::laboratory {

/// What a diagnosis says of an effect, and whether it is so.
struct StatedOdds {
  double probability{};
  bool is_there{};
};

/// A diagnosis of a set of the laboratory, compared with its answer: what the figures are counted from.
struct Outcome {
  int number{};
  std::string category;
  std::vector<std::string> conditions;
  std::vector<std::string> hidden;  ///< ids
  bool visible = true;              ///< whether every hidden effect is clear enough that it must be found
  double evidence{};                ///< of the weakest: HiddenEffect::evidence
  bool at_bound = false;
  bool state_dependent = false;  ///< whether an outsider acts on angle, rate or current, so that a correction can help

  std::string verdict;
  std::vector<std::string> reported;
  std::vector<std::vector<std::string>> ambiguous;

  bool false_name = false;       ///< an effect is reported and neither hidden nor the name of a number that is far off
  bool right_verdict = false;    ///< of sets with nothing hidden
  bool found = false;            ///< every hidden effect is reported, or in a set reported with one that is
  bool invented = false;         ///< an effect is reported that stands for none that is hidden
  bool explained_wrong = false;  ///< `explained`, by other effects than the hidden ones
  bool clear_missed = false;     ///< a hidden effect that by itself is clear is not found
  std::vector<StatedOdds> odds{};  ///< of every effect with a probability of 1 % or more
  Count effect_intervals{};
  Count number_intervals{};                  ///< stiffness, damping and declared numbers
  std::optional<double> after_over_noise{};  ///< held-out rms error over the true noise
  std::optional<double> excess_left{};  ///< of the held-out error above the noise, the share that a correction leaves
  std::optional<double> corrected_over_before{};
  bool warned = false;  ///< the diagnosis warns of something
  double seconds{};     ///< of the diagnosis
};

}  // namespace attribution::laboratory
