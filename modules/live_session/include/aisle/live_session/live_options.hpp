#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "aisle/live/tls_files.hpp"

namespace aisle {

/// Where and to whom the live server listens, and what it shows besides a mission.
struct LiveListening {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;  ///< 0: any free port
  std::filesystem::path token_file;
  TlsFiles tls;
  std::vector<std::string> origins;  ///< other sites whose pages may connect
  std::filesystem::path web;         ///< folder of the page's files; empty: the shipped page
  std::filesystem::path sessions;    ///< folder; empty: sessions cannot be listed, recorded or replayed
  std::filesystem::path buildings;   ///< folder; empty: buildings cannot be listed, learned or driven in
  std::string version;               ///< of the program
  double rate = 1;                   ///< simulated seconds per second; 0: as fast as possible
};

struct LiveOptions {
  LiveListening listening;
  std::filesystem::path connection;  ///< connection file of a robot; empty: simulated
  std::string world;                 ///< file or shipped name
  /// Drives all missions that name no other; file or shipped name. Empty: each mission's usual one.
  std::string vehicle;
  std::uint64_t seed = 1;
};

}  // namespace aisle
