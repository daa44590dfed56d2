#include "refining/refine_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "aisle/commands/learned_files.hpp"
#include "aisle/commands/output_directory.hpp"
#include "aisle/core/rounded.hpp"
#include "aisle/missions/landmarks/landmark_driver.hpp"
#include "aisle/vehicle/same_camera.hpp"

namespace aisle {
namespace {

/// Where a run began: at the start of its route, or of the return path. If a session names none of the
/// building's routes, it began at the start of the first.
Pose2 start_of(const SessionOrigin& origin, const Building& building, const VehicleDescription& vehicle) {
  for (const Route& route : building.routes) {
    if (route.name != origin.route) continue;
    const Path path = origin.in_reverse ? path_back(route.path, vehicle.footprint) : route.path;
    return path.at(0).T_map_path;
  }
  return building.routes.empty() ? Pose2{} : building.routes.front().path.at(0).T_map_path;
}

/// Refines the building with one more run. @return its figures
Result<nlohmann::ordered_json> take_in(const std::filesystem::path& session,
                                       const LandmarkLearnerParams& params, Building& building,
                                       Progress& progress) {
  auto cycles = SessionCycles::open(session);
  if (!cycles) return cycles.problems();
  const auto run = read_landmark_run(session, *cycles, params.sightings, progress);
  if (!run) return run.problems();
  if (Problems problems = check_same_camera(*building.camera, run->camera); !problems.empty())
    return at_file(problems, session.string());
  const Pose2 T_map_start = start_of(cycles->origin(), building, cycles->vehicle());
  RefinedLandmarks refined = refine_landmarks(building.landmarks, run->cycles, run->vehicle,
                                              about_start(T_map_start), params.learning);
  if (refined.matched_share < kKnownShareMin) {
    return Problem{{session.string()},
                   fmt::format("shows other landmarks than the building's: {:.0f} % of its images fit",
                               100 * refined.matched_share)};
  }
  building.landmarks = std::move(refined.map);
  return nlohmann::ordered_json{{"session", session.string()},
                                {"matched_share", rounded(refined.matched_share, 3)},
                                {"landmarks", building.landmarks.size()}};
}

/// What was said of laser recordings: a session says all of it itself.
Problems options_of_recordings(const RefineOptions& options) {
  Problems problems;
  const auto refuse_if = [&](bool is_given, const char* option) {
    if (is_given)
      problems.push_back({{option}, "is for buildings without landmarks: a session says that itself"});
  };
  refuse_if(options.T_map_hint.has_value(), "--at");
  refuse_if(!options.reading.scan_topic.empty(), "--scan");
  refuse_if(!options.reading.odometry.empty(), "--odometry");
  refuse_if(options.reading.unit != LengthUnit::kMetre, "--units");
  refuse_if(options.reading.T_vehicle_laser.has_value(), "--laser-offset");
  return problems;
}

}  // namespace

Result<Outcome> refine_landmark_building(const RefineOptions& options, const LandmarkLearnerParams& params,
                                         Building building, Console& console) {
  if (Problems problems = options_of_recordings(options); !problems.empty()) return problems;
  auto truth = read_map_truth(options.building);
  if (!truth) return truth.problems();
  const auto directory = OutputDirectory::open_if_named(options.out, options.force, learned_file_names());
  if (!directory) return directory.problems();
  const std::size_t before = building.landmarks.size();
  Outcome outcome{.verb = "refine"};
  outcome.figures = {{"landmarks_before", before}, {"trips", nlohmann::ordered_json::array()}};
  for (const std::filesystem::path& session : options.trips) {
    auto run = take_in(session, params, building, console.progress);
    if (!run) return run.problems();
    outcome.figures["trips"].push_back(std::move(*run));
  }
  outcome.figures["landmarks"] = building.landmarks.size();
  outcome.text = fmt::format("{} landmarks before, {} after {} run{}\n", before, building.landmarks.size(),
                             options.trips.size(), options.trips.size() == 1 ? "" : "s");
  if (!*directory) return outcome;
  auto files = (*directory)->write(learned_files(building, *truth, {}));
  if (!files) return files.problems();
  outcome.files = std::move(*files);
  return outcome;
}

}  // namespace aisle
