#pragma once

#include <array>
#include <cstdint>

namespace aisle {

/// From light to grey levels: noise of light and of reading out, then the response curve, then 8 bits.
class SensorResponse {
 public:
  /// @param gamma  of the curve; 1: linear
  SensorResponse(double noise_sigma, double gamma, std::uint64_t seed, std::uint64_t picture);

  /// @param light  1: just not overexposed
  std::uint8_t grey(float light, std::uint32_t pixel) const;

 private:
  static constexpr int kCurveSteps = 1024;

  float curve(float light) const;

  std::array<float, kCurveSteps + 2> grey_by_root_;  ///< of the light's square root
  float light_variance_;                             ///< of full light
  float reading_variance_;
  std::uint32_t key_[2];
};

}  // namespace aisle
