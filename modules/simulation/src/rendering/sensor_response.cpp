#include "rendering/sensor_response.hpp"

#include <algorithm>
#include <cmath>

#include "aisle/core/random.hpp"
#include "rendering/kernel.hpp"

namespace aisle {
namespace {

/// Share of a mid-grey pixel's variance that comes from reading it out.
constexpr double kReadingShare = 0.3;

/// A number drawn by a counter: the same for the same counter, and like no other.
AISLE_INLINE std::uint32_t drawn(std::uint32_t counter, const std::uint32_t (&key)[2]) {
  std::uint32_t h = counter * 0x9e3779b1u ^ key[0];
  h = (h ^ (h >> 16)) * 0x85ebca6bu;
  h = (h ^ (h >> 13) ^ key[1]) * 0xc2b2ae35u;
  return h ^ (h >> 16);
}

/// Nearly Gaussian with standard deviation 1: the sum of four bytes.
AISLE_INLINE float normal(std::uint32_t bits) {
  constexpr float kMean = 510, kPerSigma = 1 / 147.8f;
  const std::uint32_t sum = (bits & 255) + ((bits >> 8) & 255) + ((bits >> 16) & 255) + (bits >> 24);
  return (static_cast<float>(static_cast<std::int32_t>(sum)) - kMean) * kPerSigma;
}

}  // namespace

SensorResponse::SensorResponse(double noise_sigma, double gamma, std::uint64_t seed, std::uint64_t image) {
  for (int i = 0; i < kCurveSteps + 2; ++i) {
    const double root = static_cast<double>(i) / kCurveSteps;
    grey_by_root_[static_cast<std::size_t>(i)] = static_cast<float>(255 * std::pow(root, 2 / gamma));
  }
  const double mid_light = std::pow(0.5, gamma);
  const double greys_per_light = 255 * 0.5 / (gamma * mid_light);
  const double mid_variance = std::pow(noise_sigma / greys_per_light, 2);
  light_variance_ = static_cast<float>((1 - kReadingShare) * mid_variance / mid_light);
  reading_variance_ = static_cast<float>(kReadingShare * mid_variance);
  Random random(seed ^ (image * 0x9e3779b97f4a7c15u));
  for (std::uint32_t& key : key_) key = static_cast<std::uint32_t>(random.bits() >> 32);
}

AISLE_KERNEL
Greys SensorResponse::greys(const Floats& light, std::uint32_t block) const {
  constexpr float kHalf = 0.5f;  ///< to the nearest grey level
  std::int32_t steps[kLanes];
  Floats share, lower, upper;
  for (std::uint32_t k = 0; k < kLanes; ++k) {
    const float sigma = std::sqrt(light_variance_ * light.at[k] + reading_variance_);
    const float noisy = light.at[k] + sigma * normal(drawn(block * kLanes + k, key_));
    const float bounded = noisy > 0 ? (noisy < 1 ? noisy : 1) : 0;
    const float place = std::sqrt(bounded) * kCurveSteps;
    steps[k] = static_cast<std::int32_t>(place);
    share.at[k] = place - static_cast<float>(steps[k]);
  }
  for (int k = 0; k < kLanes; ++k) {
    const float* curve = grey_by_root_.data() + steps[k];
    lower.at[k] = curve[0];
    upper.at[k] = curve[1];
  }
  for (int k = 0; k < kLanes; ++k) {
    steps[k] = static_cast<std::int32_t>(kHalf + lower.at[k] + (upper.at[k] - lower.at[k]) * share.at[k]);
  }
  Greys greys;  // bytes are stored apart from the rest: for all the compiler knows they could lie anywhere
  for (std::size_t k = 0; k < kLanes; ++k) greys[k] = static_cast<std::uint8_t>(steps[k]);
  return greys;
}

}  // namespace aisle
