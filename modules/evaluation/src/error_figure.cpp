#include "aisle/evaluation/error_figure.hpp"

#include <algorithm>
#include <cmath>

namespace aisle {

void ErrorFigure::add(double error) {
  sum_of_squares_ += error * error;
  worst_ = std::max(worst_, std::abs(error));
  ++count_;
}

double ErrorFigure::rms() const {
  return count_ == 0 ? 0 : std::sqrt(sum_of_squares_ / static_cast<double>(count_));
}

}  // namespace aisle
