#pragma once

#include <cstdint>

namespace aisle {

/// Seeded random numbers, the same on every platform and standard library (xoshiro256++ seeded by
/// splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed);

  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform();
  double uniform(double min, double max) { return min + (max - min) * uniform(); }
  /// Uniform in 0 .. count-1; `count` > 0.
  std::uint64_t index(std::uint64_t count);
  /// Gaussian with mean 0.
  double normal(double sigma = 1);

 private:
  std::uint64_t state_[4];
  double spare_normal_ = 0;  ///< the Box-Muller transform gives two at once
  bool has_spare_normal_ = false;
};

}  // namespace aisle
