#pragma once

#include <cstddef>

namespace aisle {

/// How often something was met in a recording, and where first.
struct Occurrences {
  std::size_t count = 0;
  long first_line = 0;

  void add(long line, std::size_t times = 1) {
    if (times == 0) return;
    if (count == 0) first_line = line;
    count += times;
  }
};

}  // namespace aisle
