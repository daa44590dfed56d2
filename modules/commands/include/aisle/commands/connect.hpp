#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/formats/connections/connection_file.hpp"

namespace aisle {

struct ConnectOptions {
  std::filesystem::path connection;  ///< file; empty: what is found in `network`
  ConnectedNetwork network;          ///< unless there is a file
  double listen_s = 3;               ///< how long others are looked for, or listened to
};

struct ConnectInitOptions {
  ConnectOptions find;
  std::filesystem::path out;           ///< the new connection file
  std::string vehicle;                 ///< vehicle file or shipped name; empty: made of what follows
  std::optional<Footprint> footprint;  ///< of a new vehicle file
  bool is_front_steered = false;       ///< of a new vehicle file
  double wheelbase_m = 0;              ///< of a front-steered one
  double speed_max_mps = 0.3;          ///< of a new vehicle file
  bool force = false;
};

/// `aisle connect list`: the topics that a ROS 2 network has, and what each could serve for.
Result<Outcome> run_connect_list(const ConnectOptions& options, Console& console);

/// `aisle connect check`: whether a robot could be driven. Nothing is commanded.
Result<Outcome> run_connect_check(const ConnectOptions& options, Console& console);

/// `aisle connect try`: moves a robot by 0.1 m and 10 degrees; not ok if it does not move as commanded.
Result<Outcome> run_connect_try(const ConnectOptions& options, Console& console);

/// `aisle connect init`: writes a connection file from what a network has.
Result<Outcome> run_connect_init(const ConnectInitOptions& options, Console& console);

}  // namespace aisle
