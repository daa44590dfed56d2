#pragma once

#include <string>

#include "aisle/commands/driven_vehicle.hpp"
#include "aisle/commands/learn_options.hpp"
#include "aisle/commands/method_params.hpp"
#include "aisle/commands/navigate_options.hpp"
#include "aisle/commands/outcome.hpp"
#include "aisle/commands/teach_options.hpp"
#include "aisle/core/result.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// A method of learning a route from a taught run and of driving it.
struct Method {
  const char* name;
  const char* usual_vehicle;  ///< name of a shipped vehicle
  bool learns_from_several;   ///< from several taught runs along one route
  bool learns_views;          ///< a taught place may be shown by a pattern of views

  /// Makes a drive by hand one that the method can learn from. Empty on success.
  /// @param vehicle  that is driven, with at least one camera
  Problems (*prepare)(const TeachOptions& options, const VehicleDescription& vehicle, DriveOptions& drive);
  Result<Outcome> (*learn)(const LearnOptions& options, const LearnParams& params, Console& console);
  Result<Outcome> (*navigate)(const NavigateOptions& options, const NavigateParams& params, Console& console);

  /// The requested vehicle; if empty, the usual one.
  std::string vehicle_or_usual(const std::string& vehicle) const {
    return vehicle.empty() ? usual_vehicle : vehicle;
  }
};

/// The vehicle that is to drive a learned route.
VehicleChoice vehicle_choice(const NavigateOptions& options, const Method& method);

/// Each is in the folder of its method.
extern const Method kLandmarkMethod;
extern const Method kSectionMethod;
extern const Method kRoomMethod;

/// The name that a method has now.
std::string present_method(const std::string& name);

/// Likewise; a former name is warned about.
std::string present_method(const std::string& name, Console& console);

/// By its name, or the one that it had before. An unknown name is a problem that lists the methods.
Result<const Method*> method_named(const std::string& given, Console& console);

}  // namespace aisle
