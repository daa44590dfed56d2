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

/// Where and to whom the live server listens, and what it shows beside a mission.
struct LiveListening {
  std::string address = "127.0.0.1";
  std::uint16_t port = 8765;  ///< 0: any that is free
  std::filesystem::path token_file;
  TlsFiles tls;
  std::filesystem::path web;        ///< the page that was built; empty: the shipped one
  std::filesystem::path sessions;   ///< folder; empty: none can be looked at, recorded or replayed
  std::filesystem::path buildings;  ///< folder; empty: none can be looked at, learned or driven
  std::string version;              ///< of the program
  double rate = 1;                  ///< vehicle's seconds in a second; 0: as fast as it goes
};

struct LiveOptions {
  LiveListening listening;
  std::string world;  ///< file or name of a shipped one
  std::string vehicle = "alv";
  std::uint64_t seed = 1;
};

/// `aisle live WORLD`: a simulated vehicle in real time, idle until it is given over the live server what to
/// do. Goes on until it is interrupted.
/// @param announce  is given the server's address once it listens
Result<Outcome> run_live(const LiveOptions& options, Console& console,
                         const std::function<void(const std::string&)>& announce);

/// A verb's work with a console of its own; `hand` is the person who drives through the live page.
using WatchedWork = std::function<Result<Outcome>(Console& console, const DriveOptions::KeyOperator& hand)>;

/// `--live`: does a verb's work while the live server shows it, and lets it be paused and stopped.
Result<Outcome> run_watched(const LiveListening& listening, const std::string& verb, const WatchedWork& work,
                            Console& console, const std::function<void(const std::string&)>& announce);

}  // namespace aisle
