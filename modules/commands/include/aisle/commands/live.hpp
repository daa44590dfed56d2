#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "aisle/commands/drive.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/live/tls_files.hpp"

namespace aisle {

/// Where and to whom the live server listens, and what it shows besides a mission.
struct LiveListening {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;  ///< 0: any free port
  std::filesystem::path token_file;
  TlsFiles tls;
  std::filesystem::path web;        ///< folder of the page's files; empty: the shipped page
  std::filesystem::path sessions;   ///< folder; empty: sessions cannot be listed, recorded or replayed
  std::filesystem::path buildings;  ///< folder; empty: buildings cannot be listed, learned or driven in
  std::string version;              ///< of the program
  double rate = 1;                  ///< simulated seconds per second; 0: as fast as possible
};

struct LiveOptions {
  LiveListening listening;
  std::string world;  ///< file or shipped name
  std::string vehicle = "alv";
  std::uint64_t seed = 1;
};

/// `aisle live WORLD`: runs a simulated vehicle in real time. It is idle until a client of the live server
/// gives it a mission, and runs until it is interrupted.
/// @param announce  called with the server's address once it listens
Result<Outcome> run_live(const LiveOptions& options, Console& console,
                         const std::function<void(const std::string&)>& announce);

/// A verb's work with its own console; `hand` makes the operator that drives through the live page.
using WatchedWork = std::function<Result<Outcome>(Console& console, const DriveOptions::KeyOperator& hand)>;

/// `--live`: does a verb's work while the live server shows it; clients can pause and stop it.
Result<Outcome> run_watched(const LiveListening& listening, const std::string& verb, const WatchedWork& work,
                            Console& console, const std::function<void(const std::string&)>& announce);

}  // namespace aisle
