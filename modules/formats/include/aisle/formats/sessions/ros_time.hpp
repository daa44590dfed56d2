#pragma once

#include <cstdint>

#include "aisle/formats/sessions/ros_messages.hpp"

namespace aisle::ros {

/// Nanoseconds since the clock's epoch: the stamp of a session's messages.
using Stamp_ns = std::int64_t;

/// A stamp that is recorded is 0 or more, and below this one (in the year 2116): differences never overflow.
inline constexpr Stamp_ns kStampEnd_ns = Stamp_ns{1} << 62;

/// To the nearest nanosecond.
/// @param stamp_s  0 to 2^31
/// @throws std::invalid_argument outside this range
Stamp_ns stamp_ns(double stamp_s);

/// The nearest double. stamp_s(stamp_ns(t)) is t to the nanosecond; converting it again changes nothing.
double stamp_s(Stamp_ns stamp);

Time time_of(Stamp_ns stamp);
Stamp_ns stamp_ns(const Time& time);

}  // namespace aisle::ros
