#include "aisle/core/former_keys.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace aisle {
namespace {

/// Former name, present name.
constexpr auto kRenamed = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"agreeing_pictures", "agreeing_images"},
    {"aside_m", "lateral_m"},
    {"aside_max", "lateral_max"},
    {"aside_max_m", "lateral_max_m"},
    {"askew_deg", "yaw_error_deg"},
    {"askew_m", "misaligned_m"},
    {"dead_end_pictures", "dead_end_images"},
    {"doubt_m", "uncertain_m"},
    {"foot_px", "floor_point_px"},
    {"foot_share", "floor_point_share"},
    {"gates", "frontiers"},
    {"haste", "heuristic_weight"},
    {"hitches", "planning_failures"},
    {"lesson", "learner"},
    {"nooks", "pockets"},
    {"patience", "retry_budget"},
    {"patience_s", "timeout_s"},
    {"pictures", "images"},
    {"places_per_picture", "places_per_image"},
    {"room_m", "clearance_m"},
    {"route", "rooms"},
    {"same_gate_m", "same_frontier_m"},
    {"spare_wanted_m", "clearance_wanted_m"},
    {"strange_colour", "unmatched_colour"},
    {"strange_max_m", "unmatched_max_m"},
    {"strange_sightings_min", "unmatched_sightings_min"},
    {"turnabout_m", "cusp_m"},
    {"way", "path"},
    {"way_apart_m", "path_apart_m"},
    {"way_factor", "path_factor"},
    {"way_m", "path_m"},
    {"way_max_m", "path_max_m"},
    {"way_max_m_per_m2", "path_max_m_per_m2"},
    {"wish_age_max_s", "request_age_max_s"},
    {"wish_deg", "requested_deg"},
});

std::string_view present_part(std::string_view part) {
  const auto renamed =
      std::find_if(kRenamed.begin(), kRenamed.end(), [&](const auto& names) { return names.first == part; });
  return renamed == kRenamed.end() ? part : renamed->second;
}

}  // namespace

std::string_view former_key(std::string_view present_key) {
  const auto renamed = std::find_if(kRenamed.begin(), kRenamed.end(),
                                    [&](const auto& names) { return names.second == present_key; });
  return renamed == kRenamed.end() ? present_key : renamed->first;
}

std::string present_key(std::string_view former_key) {
  std::string key;
  for (std::size_t begin = 0; begin <= former_key.size();) {
    const std::size_t end = std::min(former_key.find('.', begin), former_key.size());
    if (begin > 0) key += '.';
    key += present_part(former_key.substr(begin, end - begin));
    begin = end + 1;
  }
  return key;
}

}  // namespace aisle
