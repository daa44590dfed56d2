#pragma once

namespace aisle {

constexpr double square(double x) {
  return x * x;
}

}  // namespace aisle
