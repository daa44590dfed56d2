#pragma once

#include <array>
#include <cstdint>

#include "rendering/packet.hpp"

namespace aisle {

using Greys = std::array<std::uint8_t, kLanes>;

/// From light to grey levels: noise of light and of reading out, then the response curve, then 8 bits.
class SensorResponse {
 public:
  /// @param gamma  of the curve; 1: linear
  SensorResponse(double noise_sigma, double gamma, std::uint64_t seed, std::uint64_t image);

  /// @param light  of a block's pixels; 1: just not overexposed
  /// @param block  its number: noise is drawn by it
  Greys greys(const Floats& light, std::uint32_t block) const;

 private:
  static constexpr int kCurveSteps = 1024;

  std::array<float, kCurveSteps + 2> grey_by_root_;  ///< of the light's square root
  float light_variance_;                             ///< of full light
  float reading_variance_;
  std::uint32_t key_[2];
};

}  // namespace aisle
