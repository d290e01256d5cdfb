#pragma once

namespace attribution {

/// A number of hits among a number of cases.
struct Count {
  int hits{};
  int of{};

  void add(bool hit) {
    hits += hit ? 1 : 0;
    ++of;
  }
  Count& operator+=(const Count& other) {
    hits += other.hits;
    of += other.of;
    return *this;
  }
};

}  // namespace attribution
