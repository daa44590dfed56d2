#include "aisle/formats/sessions/ros_time.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace aisle::ros {
namespace {

constexpr Stamp_ns kSecond_ns = 1'000'000'000;
constexpr double kStampEnd_s = 2147483648.0;  // where the seconds of a Time overflow

}  // namespace

Stamp_ns stamp_ns(double stamp_s) {
  if (!(stamp_s >= 0 && stamp_s < kStampEnd_s))
    throw std::invalid_argument(fmt::format("the stamp {} s is not within 0 to 2^31 s", stamp_s));
  const double whole_s = std::floor(stamp_s);
  return static_cast<Stamp_ns>(whole_s) * kSecond_ns + std::llround((stamp_s - whole_s) * 1e9);
}

double stamp_s(Stamp_ns stamp) {
  const Stamp_ns whole_s = stamp / kSecond_ns;
  return static_cast<double>(whole_s) + static_cast<double>(stamp % kSecond_ns) / 1e9;
}

Time time_of(Stamp_ns stamp) {
  return {.sec = static_cast<std::int32_t>(stamp / kSecond_ns),
          .nanosec = static_cast<std::uint32_t>(stamp % kSecond_ns)};
}

Stamp_ns stamp_ns(const Time& time) {
  return time.sec * kSecond_ns + time.nanosec;
}

}  // namespace aisle::ros
