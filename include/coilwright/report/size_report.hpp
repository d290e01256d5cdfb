#pragma once

#include <string>

#include "coilwright/sizing/search/search.hpp"
#include "coilwright/sizing/study/design_problem.hpp"
#include "coilwright/text/json/json.hpp"

namespace coilwright::report {

/// What `size` found, to be written. Everything referred to must outlive it.
struct SizeAnswer {
  const sizing::Study& study;           ///< with the options that were used
  const sizing::SearchResult& result;   ///< of the search
  const sizing::DesignResult* best{};   ///< `result.best` evaluated again; nullptr if nothing was evaluated
  const sizing::DesignResult& base;     ///< the actuator that the study starts from
  const sizing::Evaluation& base_seen;  ///< what the search would be told of it
};

/// result.json of `size`; its keys are in docs/formats.md.
[[nodiscard]] text::Json to_json(const SizeAnswer& answer);

/// The same for a person, who has a minute.
[[nodiscard]] std::string to_text(const SizeAnswer& answer);

}  // namespace coilwright::report
