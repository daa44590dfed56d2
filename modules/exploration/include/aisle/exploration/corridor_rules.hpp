#pragma once
/// The rules by which a vehicle explores a real building: C99's navigation transducer (section 4.1) as data.
/// docs/explanation/exploration.md explains the inputs.

#include "aisle/exploration/pushdown_transducer.hpp"

namespace aisle {

/// Where a path leads, relative to the vehicle's heading when it was first seen.
enum class Bearing : Symbol { kForward, kLeft, kRight };

inline constexpr Bearing kBearings[] = {Bearing::kForward, Bearing::kLeft, Bearing::kRight};

enum class CorridorState : Symbol { kExploring, kRetreating, kFinal };

/// Stack symbols: the start symbol, a path to explore, the return path to a crossing.
inline constexpr Symbol kCorridorStackStart = 0;
constexpr Symbol explore_symbol(Bearing bearing) {
  return static_cast<Symbol>(1 + static_cast<Symbol>(bearing));
}
inline constexpr Symbol kPathBackSymbol = 4;

/// C99's seven operations.
enum class CorridorOutput : Symbol {
  kForward,
  kForwardLeft,
  kForwardRight,
  kBackward,
  kBackwardLeft,
  kBackwardRight,
  kStop
};

/// Inputs. The paper's crossing is presented path by path: first the return path, then every path that is
/// left for later.
namespace corridor_input {
constexpr Symbol one_direction(Bearing bearing) {
  return static_cast<Symbol>(bearing);
}
constexpr Symbol crossing(Bearing bearing) {
  return static_cast<Symbol>(3 + static_cast<Symbol>(bearing));
}
inline constexpr Symbol kCrossingPathBack = 6;
inline constexpr Symbol kEnd = 7;
inline constexpr Symbol kExplored = 8;  ///< nothing new lies ahead of the vehicle
inline constexpr Symbol kClosed = 9;  ///< beyond the paper: the path on top of the stack is explored already
constexpr Symbol detour(Bearing bearing) {  ///< beyond the paper: a path below the top is taken first
  return static_cast<Symbol>(10 + static_cast<Symbol>(bearing));
}
inline constexpr Symbol kAway = 13;  ///< beyond the paper: no path waits, and the vehicle is not at home
}  // namespace corridor_input

/// Built once, then shared.
const TransducerTable& corridor_rules();

}  // namespace aisle
