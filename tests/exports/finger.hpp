#pragma once

#include <string>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/exports/subject.hpp"

namespace coilwright::exports {

/// A design as an export takes it.
inline DesignSubject subject_of(const actuator::Design& design, std::string name = "finger") {
  return {.origin = {.name = std::move(name), .made_by = "a test"},
          .design = design,
          .assembly = actuator::assemble_or_throw(design)};
}

/// The text of one file of an export; empty where there is none.
inline std::string text_of(const std::vector<ExportedFile>& files, std::string_view name) {
  for (const ExportedFile& file : files)
    if (file.name == name) return file.text;
  return "";
}

}  // namespace coilwright::exports
