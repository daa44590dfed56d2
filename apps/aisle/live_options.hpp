#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "aisle/commands/live.hpp"
#include "verb.hpp"

/// Where and to whom is served, by what certificate, and how fast: --port to --rate.
void add_listening_options(CLI::App& verb, aisle::LiveListening& listening);

/// Says on stderr where the page is.
void announce_live(const std::string& url);

/// --live and what goes with it, for a verb whose work can be watched.
class LiveOption {
 public:
  explicit LiveOption(CLI::App& verb);

  bool is_wanted() const { return *is_wanted_; }
  /// The work, shown live if that is wanted.
  Work around(const aisle::WatchedWork& work) const;

 private:
  std::string verb_;
  std::shared_ptr<bool> is_wanted_;
  std::shared_ptr<aisle::LiveListening> listening_;
};
