#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/guidance/hand_driver.hpp"
#include "aisle/guidance/key_controls.hpp"
#include "aisle/simulation/operators/operator.hpp"
#include "aisle/simulation/operators/scripted_operator.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

struct DriveParams {
  HandDriverParams limits;
  KeySpeeds keys;
  ScriptedOperatorParams person;

  void describe(FieldList& fields) {
    fields.group("limits", limits);
    fields.group("keys", keys);
    fields.group("person", person);
  }
};

struct DriveOptions {
  std::string world;  ///< as all three: a file or the name of a shipped one
  std::string vehicle = "alv";
  std::string scenario;                ///< empty: nothing goes wrong
  std::string camera;                  ///< the only one that takes images; empty: all do
  std::string route;                   ///< what the session calls the path that is driven; may be empty
  std::optional<Pose2> T_world_start;  ///< else the world's
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< of the session; empty: none is kept
  bool force = false;
  bool takes_images = true;
  ParameterSources parameters;

  /// Makes the person at the keys; null: a person follows the world's tour by itself.
  using KeyOperator =
      std::function<Result<std::unique_ptr<Operator>>(const VehicleDescription&, const KeySpeeds&)>;
  KeyOperator keys;
};

/// `aisle drive WORLD`: drives a simulated vehicle by hand.
Result<Outcome> run_drive(const DriveOptions& options, Console& console);

/// Every parameter of `aisle drive` with its default.
Outcome drive_parameters();

}  // namespace aisle
