#pragma once

namespace aisle {

/// Which way base_link moves along its own x axis.
enum class Gear { kForward, kReverse };

/// Factor of lengths and speeds, which are positive forwards.
constexpr double sign(Gear gear) {
  return gear == Gear::kForward ? 1 : -1;
}

constexpr Gear opposite(Gear gear) {
  return gear == Gear::kForward ? Gear::kReverse : Gear::kForward;
}

/// Of a signed length or speed; none counts as forwards.
constexpr Gear gear_of(double length_or_speed) {
  return length_or_speed < 0 ? Gear::kReverse : Gear::kForward;
}

}  // namespace aisle
