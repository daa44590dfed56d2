#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "aisle/formats/logs/laser_recording.hpp"
#include "aisle/formats/sessions/session_storage.hpp"
#include "aisle/geometry/pose2.hpp"
#include "aisle/missions/exploration/exploring_sensor.hpp"
#include "aisle/missions/exploration/guide_driver.hpp"

template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// An option whose value is one of a few words. The help lists them, and so does the refusal of another word.
template <class Value>
void add_choice(CLI::App& verb, const std::string& name, Value& chosen, const Choices<Value>& choices,
                const std::string& meaning) {
  std::vector<std::string> words;
  for (const auto& choice : choices) words.push_back(choice.first);
  const auto choose = [=, &chosen](const std::string& word) {
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&](const auto& choice) { return choice.first == word; });
    if (found == choices.end()) {
      throw CLI::ValidationError(name, fmt::format("'{}' is none of {}", word, fmt::join(words, ", ")));
    }
    chosen = found->second;
  };
  verb.add_option_function<std::string>(name, choose, meaning)
      ->type_name(fmt::format("{}", fmt::join(words, "|")));
}

/// Parses "x,y,heading_deg", the pose of a vehicle [m, degrees].
aisle::Pose2 parse_place(const std::string& option, const std::string& text);

/// The value of --at: "home", "unknown", or a pose in the map as a hint.
aisle::MissionStart parse_told_start(const std::string& text);

/// --sensor: the sensor to explore with.
void add_exploring_sensor(CLI::App& verb, aisle::ExploringSensor& sensor, const std::string& meaning);

/// --resolution: metres per pixel of a plan.
void add_resolution(CLI::App& verb, double& pixel_m);

/// --scan, --odometry, --units, --laser-offset: how a recording of scans is read.
void add_reading_options(CLI::App& verb, aisle::RecordingOptions& reading);

/// --storage: what the file of a new session is.
void add_storage(CLI::App& verb, aisle::SessionStorage& storage);

/// --seed: a non-negative whole number.
void add_seed(CLI::App& verb, std::uint64_t& seed, const std::string& meaning);
