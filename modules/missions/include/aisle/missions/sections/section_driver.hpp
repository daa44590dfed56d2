#pragma once
/// Makes the section navigator for missions and for their replays, both from the origin that the session
/// records.

#include <memory>
#include <string>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/sections/section_navigator.hpp"

namespace aisle {

inline constexpr const char* kSectionNavigator = "sections";  ///< name of the navigator in a session

struct SectionDriverParams {
  SectionNavigatorParams navigator;
  bool and_back = false;

  void describe(FieldList& fields) {
    navigator.describe(fields);
    fields.flag("and_back", and_back, "at the end the vehicle turns around and drives back home");
  }
};

/// What keeps a vehicle from learning and driving sections: no camera, or no turns on the spot.
Problems unfit_for_sections(const VehicleDescription& vehicle);

/// Problems: parameters and building that cannot be read, an unknown route, one without sections, a vehicle
/// without a camera or that cannot turn on the spot.
Result<std::unique_ptr<SectionNavigator>> make_section_navigator(const SessionOrigin& origin,
                                                                 const VehicleDescription& vehicle);

}  // namespace aisle
