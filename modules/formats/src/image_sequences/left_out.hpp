#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "aisle/core/problem.hpp"

namespace aisle {

/// Things of one kind that were left out: how many, and the first of them.
class LeftOut {
 public:
  void add(Problem problem) {
    if (count_++ == 0) first_ = std::move(problem);
  }

  std::size_t count() const { return count_; }
  const Problem& first() const { return first_; }

  /// Adds one warning for all of them: "FIRST PLACE: `kind`: N left out; the first WHAT". None: none.
  void warn(const std::string& kind, Problems& warnings) const;

 private:
  std::size_t count_ = 0;
  Problem first_;
};

}  // namespace aisle
