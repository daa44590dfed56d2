#include "aisle/guidance/exploration/exploring_phase.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace aisle {

std::string_view name_of(ExploringPhase phase) {
  switch (phase) {
    case ExploringPhase::kLooking:
      return "looking";
    case ExploringPhase::kSearching:
      return "searching";
    case ExploringPhase::kDriving:
      return "driving";
    case ExploringPhase::kRetreating:
      return "retreating";
    case ExploringPhase::kProbing:
      return "probing";
    case ExploringPhase::kHome:
      return "home";
    case ExploringPhase::kGivenUp:
      return "given up";
  }
  return "";
}

std::string_view name_of(ExploringEvent event) {
  switch (event) {
    case ExploringEvent::kLookedAround:
      return "looked around";
    case ExploringEvent::kPathFound:
      return "path found";
    case ExploringEvent::kTrailFound:
      return "trail found";
    case ExploringEvent::kProbeFound:
      return "probe found";
    case ExploringEvent::kPathEnded:
      return "path ended";
    case ExploringEvent::kPathDropped:
      return "path dropped";
    case ExploringEvent::kCameHome:
      return "came home";
    case ExploringEvent::kGaveUp:
      return "gave up";
  }
  return "";
}

ExploringPhase phase_after(ExploringPhase phase, ExploringEvent event) {
  const auto next = kExploringTable.at(static_cast<std::size_t>(phase)).at(static_cast<std::size_t>(event));
  if (!next)
    throw std::logic_error(
        fmt::format("explorer: '{}' cannot happen in phase '{}'", name_of(event), name_of(phase)));
  return *next;
}

}  // namespace aisle
