#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "aisle/core/result.hpp"

namespace aisle {

/// What made a session: all that a replay needs beside the observations.
struct SessionOrigin {
  std::string navigator;                          ///< who decided, by name: "hand"
  std::map<std::string, std::string> parameters;  ///< the navigator's, where they differ from the defaults
  std::uint64_t seed = 0;
  bool simulated = false;
  std::string building = {};  ///< what the navigator knew, as the text of a building file; empty: nothing
  std::string route = {};     ///< of that building, which it drove; empty: none
  bool in_reverse = false;    ///< the route's return path

  friend bool operator==(const SessionOrigin&, const SessionOrigin&) = default;
};

/// As the JSON of the topic /session.
std::string session_origin_json(const SessionOrigin& origin);

/// `name` stands for the file in problems.
Result<SessionOrigin> parse_session_origin(std::string_view text, const std::string& name);

}  // namespace aisle
