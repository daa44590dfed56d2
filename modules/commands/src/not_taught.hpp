#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// The taught runs that a trial's seeds were to give and that were refused: without one there is no mission.
class NotTaught {
 public:
  /// @param route  where a seed may give one of several
  void add(std::uint64_t seed, const std::string& why, const std::string& route = {}) {
    nlohmann::ordered_json learned = {{"seed", seed}};
    if (!route.empty()) learned["route"] = route;
    learned["why"] = why;
    runs_learned_.push_back(std::move(learned));
    text_ += fmt::format("seed {}{}{}: {}\n", seed, route.empty() ? "" : ", ", route, why);
  }

  std::size_t size() const { return runs_learned_.size(); }
  const nlohmann::ordered_json& json() const { return runs_learned_; }
  /// A line each.
  const std::string& text() const { return text_; }

 private:
  nlohmann::ordered_json runs_learned_ = nlohmann::ordered_json::array();
  std::string text_;
};

}  // namespace aisle
