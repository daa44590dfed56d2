#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/sessions/session_storage.hpp"

namespace aisle {

struct NavigateOptions {
  std::filesystem::path building;
  std::filesystem::path connection;  ///< connection file of a robot; empty: simulated
  std::string world;
  std::string vehicle;   ///< empty: the method's default, alv or mini (sections)
  std::string scenario;  ///< file or shipped name; empty: no faults
  std::string method = "landmarks";
  std::string route;  ///< name; empty: the building's first
  bool in_reverse = false;
  bool and_back = false;  ///< sections: turn around at the end and drive back home
  std::optional<double> speed_mps;
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< directory of the session; empty: not recorded
  bool force = false;
  SessionStorage storage = SessionStorage::kSqlite;
  ParameterSources parameters;
};

}  // namespace aisle
