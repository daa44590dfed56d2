#pragma once

#include <string>

#include "aisle/commands/import_recording.hpp"
#include "aisle/formats/sessions/imported_session.hpp"
#include "imports/imported_recording.hpp"

namespace aisle {

/// The vehicle that a session describes, and what of it is more than placeholders.
struct ImportedVehicle {
  VehicleDescription description;
  KnownSensors known;
  std::string camera;  ///< that took the images; empty: there are none
};

/// The vehicle that the user names, with the camera and the scanner that recorded; or an unknown one, of
/// which there is what the recording tells.
/// @param named  by the user; none: unknown
Result<ImportedVehicle> imported_vehicle(std::optional<VehicleDescription> named,
                                         const ImportedRecording& recording, const ImportOptions& options);

/// What the session's description of the vehicle lacks, or has otherwise than the recording.
Problems vehicle_warnings(const ImportedVehicle& vehicle, const ImportedRecording& recording,
                          const ImportOptions& options);

}  // namespace aisle
