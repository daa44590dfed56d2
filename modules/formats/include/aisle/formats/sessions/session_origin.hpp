#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"

namespace aisle {

/// What produced a session: all that a replay needs besides the observations.
struct SessionOrigin {
  std::string navigator;                          ///< the name of the navigator that decided: "hand"
  std::map<std::string, std::string> parameters;  ///< the navigator's, where they differ from the defaults
  std::uint64_t seed = 0;
  bool simulated = false;
  std::string building = {};    ///< the navigator's initial map, as a building file's text; empty: none
  std::string route = {};       ///< the route of that building that it drove; empty: none
  bool in_reverse = false;      ///< the route was driven back
  bool has_odometry = true;     ///< false: an imported recording without it; cycles say that nothing moved
  bool has_calibration = true;  ///< false: the vehicle's lens and mount are placeholders

  friend bool operator==(const SessionOrigin&, const SessionOrigin&) = default;
};

/// As the JSON of the topic /session.
std::string session_origin_json(const SessionOrigin& origin);

/// `name` is the file name in problems.
Result<SessionOrigin> parse_session_origin(std::string_view text, const std::string& name);

}  // namespace aisle
