#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "aisle/commands/outcome.hpp"
#include "aisle/commands/parameter_sources.hpp"
#include "aisle/formats/sessions/session_storage.hpp"
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
  std::string world;  ///< world, vehicle and scenario: file or shipped name
  std::string vehicle = "alv";
  std::string scenario;                ///< file or shipped name; empty: no faults
  std::string camera;                  ///< the only camera that takes images; empty: all cameras do
  std::string route;                   ///< name of the driven route in the session; may be empty
  std::optional<Pose2> T_world_start;  ///< none: the world's start
  std::uint64_t seed = 1;
  std::filesystem::path connection;  ///< connection file of a robot; empty: simulated
  bool by_joystick = false;          ///< a robot: its joystick drives, beside `keys`
  bool only_listens = false;         ///< a robot: another program drives it, and nothing is sent
  std::filesystem::path out;         ///< directory of the session; empty: not recorded
  bool force = false;
  SessionStorage storage = SessionStorage::kSqlite;
  bool takes_images = true;
  ParameterSources parameters;

  /// What keeps a robot from what is driven for, asked when it has said all of itself; null: nothing does.
  std::function<Problems(const VehicleDescription&)> unfit;

  /// The file that says what the vehicle is.
  std::string vehicle_file() const { return connection.empty() ? vehicle : connection.string(); }

  /// Makes the operator at the keys; null: a scripted person follows the world's tour, and a robot has nobody
  /// at the keys.
  using KeyOperator =
      std::function<Result<std::unique_ptr<Operator>>(const VehicleDescription&, const KeySpeeds&)>;
  KeyOperator keys;
};

/// `aisle drive WORLD`: a person drives a simulated vehicle, or a robot.
Result<Outcome> run_drive(const DriveOptions& options, Console& console);

/// Every parameter of `aisle drive` with its default.
Outcome drive_parameters();

}  // namespace aisle
