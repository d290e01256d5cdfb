#pragma once

#include <stdexcept>

namespace coilwright::measurement::records {

/// Records that were written in another unit or with another sign than their columns say; names run, column and remedy.
class RecordSlip : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

}  // namespace coilwright::measurement::records
