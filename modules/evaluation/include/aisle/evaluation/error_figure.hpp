#pragma once

#include <cstddef>

namespace aisle {

/// Root mean square and greatest magnitude of an error.
class ErrorFigure {
 public:
  void add(double error);
  double rms() const;
  double worst() const { return worst_; }
  std::size_t count() const { return count_; }

 private:
  double sum_of_squares_ = 0;
  double worst_ = 0;
  std::size_t count_ = 0;
};

}  // namespace aisle
