#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "aisle/core/problem.hpp"

namespace aisle {

/// The record of a mission that was not driven, because its taught run was refused.
/// @param route  its name, if a seed may teach one of several
inline nlohmann::ordered_json not_taught_record(std::uint64_t seed, const std::string& why,
                                                const std::string& route = {}) {
  nlohmann::ordered_json refused = {{"seed", seed}};
  if (!route.empty()) refused["route"] = route;
  refused["why"] = why;
  return {{"ok", true}, {"not_taught", refused}};
}

/// The taught runs of a trial that were refused: a seed without a taught run has no mission.
class NotTaught {
 public:
  /// @return whether the record is that of a refused run
  bool add(const nlohmann::ordered_json& record) {
    if (!record.contains("not_taught")) return false;
    const nlohmann::ordered_json& refused = record["not_taught"];
    const std::string route = refused.value("route", "");
    text_ += fmt::format("seed {}{}{}: {}\n", refused.at("seed").get<std::uint64_t>(),
                         route.empty() ? "" : ", ", route, refused.at("why").get<std::string>());
    refused_runs_.push_back(refused);
    return true;
  }

  const nlohmann::ordered_json& json() const { return refused_runs_; }
  /// One line per refused run.
  const std::string& text() const { return text_; }

 private:
  nlohmann::ordered_json refused_runs_ = nlohmann::ordered_json::array();
  std::string text_;
};

}  // namespace aisle
