#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "aisle/live_session/live.hpp"
#include "verb.hpp"

/// The options of the live server, --port to --rate: address, access, TLS, folders and speed.
void add_listening_options(CLI::App& verb, aisle::LiveListening& listening);

/// Prints the address of the page to stderr.
void announce_live(const std::string& url);

/// --live and the options of its server, for a verb whose work can be watched.
class LiveOption {
 public:
  explicit LiveOption(CLI::App& verb);

  bool is_wanted() const { return *is_wanted_; }
  /// Wraps the work so that the live server shows it if --live was given.
  Work around(const aisle::WatchedWork& work) const;

 private:
  std::string verb_;
  std::shared_ptr<bool> is_wanted_;
  std::shared_ptr<aisle::LiveListening> listening_;
};
