#pragma once
/// What an exploring vehicle is doing, and what may happen to it then, as a table.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace aisle {

enum class ExploringPhase {
  kLooking,     ///< stands and looks around before it starts
  kSearching,   ///< has no path: chooses a target and searches for one
  kDriving,     ///< follows a path
  kRetreating,  ///< drives back along its trail
  kProbing,     ///< creeps over unknown floor near where it was put
  kHome,        ///< stands where it started, and nothing is left to be explored
  kGivenUp,
};

enum class ExploringEvent {
  kLookedAround,
  kPathFound,    ///< a path begins where the vehicle is, or where its path ends
  kTrailFound,   ///< the vehicle can go back along its trail
  kProbeFound,   ///< a path begins where the vehicle is, and leads over unknown floor
  kPathEnded,    ///< it has driven its path, or was at its target already
  kPathDropped,  ///< path and target, if any, are no longer wanted
  kCameHome,
  kGaveUp,
};

inline constexpr std::size_t kExploringPhases = 7;
inline constexpr std::size_t kExploringEvents = 8;

/// The phase after each event, by phase; nullopt: the event cannot happen then.
using ExploringTable =
    std::array<std::array<std::optional<ExploringPhase>, kExploringEvents>, kExploringPhases>;

inline constexpr ExploringTable kExploringTable = [] {
  using enum ExploringPhase;
  constexpr std::nullopt_t kNever = std::nullopt;
  // looked around, path found, trail found, probe found, path ended, path dropped, came home, gave up
  return ExploringTable{{
      /* looking    */ {kSearching, kNever, kNever, kNever, kNever, kLooking, kNever, kGivenUp},
      /* searching  */ {kNever, kDriving, kRetreating, kProbing, kSearching, kSearching, kHome, kGivenUp},
      /* driving    */ {kNever, kDriving, kNever, kNever, kSearching, kSearching, kNever, kGivenUp},
      /* retreating */ {kNever, kNever, kNever, kNever, kSearching, kSearching, kNever, kGivenUp},
      /* probing    */ {kNever, kNever, kNever, kNever, kSearching, kSearching, kNever, kGivenUp},
      /* home       */ {kNever, kNever, kNever, kNever, kNever, kHome, kNever, kHome},
      /* given up   */ {kNever, kNever, kNever, kNever, kNever, kGivenUp, kNever, kGivenUp},
  }};
}();

std::string_view name_of(ExploringPhase phase);
std::string_view name_of(ExploringEvent event);

/// @throws std::logic_error that names both if the event cannot happen in that phase
ExploringPhase phase_after(ExploringPhase phase, ExploringEvent event);

}  // namespace aisle
