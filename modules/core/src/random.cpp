#include "aisle/core/random.hpp"

#include <bit>
#include <cmath>

#include "aisle/core/angle.hpp"

namespace aisle {

Random::Random(std::uint64_t seed) {
  for (std::uint64_t& word : state_) {  // splitmix64
    seed += 0x9e3779b97f4a7c15u;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    word = z ^ (z >> 31);
  }
}

std::uint64_t Random::bits() {  // xoshiro256++
  const std::uint64_t result = std::rotl(state_[0] + state_[3], 23) + state_[0];
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1.0p-53;
}

std::uint64_t Random::index(std::uint64_t count) {
  const std::uint64_t limit =
      -count % count;  // 2^64 mod count: reject below it, so that no index is favoured
  std::uint64_t drawn = bits();
  while (drawn < limit) drawn = bits();
  return drawn % count;
}

double Random::normal(double sigma) {
  if (has_spare_normal_) {
    has_spare_normal_ = false;
    return sigma * spare_normal_;
  }
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));  // Box-Muller
  const double angle = 2 * kPi * uniform();
  spare_normal_ = radius * std::sin(angle);
  has_spare_normal_ = true;
  return sigma * radius * std::cos(angle);
}

}  // namespace aisle
