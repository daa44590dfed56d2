#include "fleet/paced_vehicle.hpp"

#include <algorithm>
#include <thread>

namespace aisle {

std::optional<Observation> PacedVehicle::sense() {
  std::optional<Observation> observation = vehicle_.sense();
  if (!observation) return observation;
  const auto now = std::chrono::steady_clock::now();
  if (stamp_s_) {
    const std::chrono::duration<double> lasts((observation->stamp_s - *stamp_s_) / rate_);
    // A cycle that took too long is not caught up with: the vehicle's time has passed more slowly.
    due_ = std::max(now, due_ + std::chrono::duration_cast<std::chrono::steady_clock::duration>(lasts));
    std::this_thread::sleep_until(due_);
  } else {
    due_ = now;
  }
  stamp_s_ = observation->stamp_s;
  return observation;
}

}  // namespace aisle
