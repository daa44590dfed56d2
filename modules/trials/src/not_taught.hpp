#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// The taught runs of a trial that were refused: a seed without a taught run has no mission.
class NotTaught {
 public:
  /// @param route  its name, if a seed may teach one of several
  void add(std::uint64_t seed, const std::string& why, const std::string& route = {}) {
    nlohmann::ordered_json refused = {{"seed", seed}};
    if (!route.empty()) refused["route"] = route;
    refused["why"] = why;
    refused_runs_.push_back(std::move(refused));
    text_ += fmt::format("seed {}{}{}: {}\n", seed, route.empty() ? "" : ", ", route, why);
  }

  std::size_t size() const { return refused_runs_.size(); }
  const nlohmann::ordered_json& json() const { return refused_runs_; }
  /// One line per refused run.
  const std::string& text() const { return text_; }

 private:
  nlohmann::ordered_json refused_runs_ = nlohmann::ordered_json::array();
  std::string text_;
};

}  // namespace aisle
