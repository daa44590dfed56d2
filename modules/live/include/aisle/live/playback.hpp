#pragma once

#include <cstdint>

#include "aisle/formats/sessions/ros_time.hpp"

namespace aisle {

enum class PlaybackStatus : std::uint8_t { kPlaying = 0, kPaused = 1, kEnded = 3 };  // as on the wire

/// How far the replay of a recorded session is, for viewers with controls of their own for it.
struct Playback {
  ros::Stamp_ns first = 0, last = 0;  ///< of the session
  ros::Stamp_ns at = 0;
  double rate = 1;  ///< seconds per second
  PlaybackStatus status = PlaybackStatus::kPlaying;
  bool did_seek = false;  ///< `at` has jumped
};

}  // namespace aisle
