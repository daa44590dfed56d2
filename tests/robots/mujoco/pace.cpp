#include "pace.hpp"

#include <cmath>
#include <thread>

namespace robots {
namespace {

using std::chrono::nanoseconds;

nanoseconds from_seconds(double seconds) {
  return nanoseconds(std::llround(1e9 * seconds));
}

}  // namespace

Pace::Pace(double speed, bool simulated_clock) : speed_(speed), simulated_clock_(simulated_clock) {
  if (!simulated_clock) start_stamp_ = std::chrono::system_clock::now().time_since_epoch();
}

void Pace::wait_for(double simulated_s) {
  constexpr std::chrono::milliseconds kForgiven(50);
  const auto due = start_ + from_seconds(simulated_s / speed_);
  const auto late = Steady::now() - due;
  if (late <= kForgiven) {
    std::this_thread::sleep_until(due);
    return;
  }
  start_ += late;
  if (!simulated_clock_) start_stamp_ += late;
}

Time Pace::stamp(double simulated_s) const {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t stamp = (start_stamp_ + from_seconds(simulated_s)).count();
  return {static_cast<std::int32_t>(stamp / kSecond), static_cast<std::uint32_t>(stamp % kSecond)};
}

double Pace::wall_s() const {
  return std::chrono::duration<double>(Steady::now() - began_).count();
}

}  // namespace robots
