#pragma once
/// What happened while a building was explored, as far as the vehicle itself can tell.

#include <cstddef>
#include <string>
#include <vector>

#include "aisle/geometry/pose2.hpp"

namespace aisle {

/// Something happened to a path that was seen to lead on: C99's stack symbols with their places.
struct PathEvent {
  enum class Kind {
    kPushed,     ///< seen, and left for later
    kTaken,      ///< popped: entered, or resumed
    kExplored,   ///< all that it led to is known; popped if it was still on the stack
    kGivenUp,    ///< the vehicle cannot get there; seen from outside only
    kAbandoned,  ///< the time ran out before the vehicle got there
  };
  std::size_t cycle = 0;
  Kind kind = Kind::kPushed;
  std::size_t path = 0;       ///< numbered in the order in which they were seen
  std::size_t parent = 0;     ///< the path from which it was first seen; its own number: from the start
  std::string symbol;         ///< on the stack: "E_front", "E_left", "E_right"
  Vec2 p_map = Vec2::Zero();  ///< where the known floor ends there
};

/// What went in and out of the transducer in the cycles from this one on.
struct TransducerStep {
  std::size_t cycle = 0;
  std::string state;
  std::string input;
  std::string output;
  std::size_t stack = 0;  ///< symbols on the stack
};

/// How much was known after a distance driven.
struct CoverageMark {
  double path_m = 0;
  double free_m2 = 0;
};

struct ExplorationRecord {
  std::vector<PathEvent> paths;
  std::vector<TransducerStep> steps;
  std::vector<CoverageMark> coverage;  ///< every half metre driven
  std::vector<Pose2> T_map_vehicle;    ///< one a cycle, as known at the end
  std::size_t paths_waiting = 0;       ///< pushed, and neither explored nor given up
  std::size_t paths_abandoned = 0;     ///< the time ran out before they were explored
  double path_m = 0;                   ///< driven, forwards and backwards, as the vehicle measured it
  bool came_home = false;
  std::string ended_because;  ///< "explored" or why not

  /// Every pushed path was popped, none was abandoned, and the vehicle came home.
  bool certified() const {
    return came_home && paths_waiting == 0 && paths_abandoned == 0 && ended_because == "explored";
  }
};

}  // namespace aisle
