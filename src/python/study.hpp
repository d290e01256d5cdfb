#pragma once

#include "coilwright/sizing/study/study.hpp"

namespace coilwright::python {

/// A study as Python holds it, read and checked.
struct Study {
  sizing::Study content;
};

}  // namespace coilwright::python
