#include "aisle/commands/learned_files.hpp"

#include <fmt/format.h>

#include "aisle/formats/buildings/building_json.hpp"
#include "aisle/formats/logs/trajectory.hpp"
#include "aisle/report/landmark_picture.hpp"

namespace aisle {
namespace {

constexpr const char* kLandmarksPicture = "landmarks.svg";
constexpr const char* kTrip = "trip.tum";
constexpr const char* kTripTruth = "trip_truth.tum";

std::string numbered_tum(const std::vector<Pose2>& poses) {
  std::vector<double> numbers;
  for (std::size_t i = 0; i < poses.size(); ++i) numbers.push_back(static_cast<double>(i));
  return tum_text(numbers, poses);
}

std::string landmarks_svg(const Building& building, const std::vector<Pose2>& T_map_driven,
                          const std::vector<Vec2>& p_map_sightings) {
  std::vector<std::vector<Pose2>> driven;
  if (!T_map_driven.empty()) driven.push_back(T_map_driven);
  return svg(LandmarkPicture{.landmarks = building.landmarks,
                             .routes = building.routes,
                             .driven = driven,
                             .seen = p_map_sightings,
                             .title = building.name.empty() ? "learned building" : building.name,
                             .caption = fmt::format("{} landmarks", building.landmarks.size())});
}

}  // namespace

std::vector<std::string> learned_file_names() {
  return {"building.json", kLandmarksPicture, kTrip, kTripTruth};
}

std::vector<std::string> truth_file_names() {
  return {kTrip, kTripTruth};
}

std::vector<OutputFile> truth_files(const MapTruth& truth) {
  return {{"trip", kTrip, numbered_tum(truth.T_map_taught())},
          {"trip_truth", kTripTruth, numbered_tum(truth.T_world_taught())}};
}

std::vector<OutputFile> learned_files(const Building& building, const MapTruth& truth,
                                      const std::vector<Vec2>& p_map_sightings) {
  std::vector<OutputFile> files = {
      {"building", "building.json", building_json(building)},
      {"landmarks_svg", kLandmarksPicture, landmarks_svg(building, truth.T_map_taught(), p_map_sightings)}};
  for (OutputFile& file : truth_files(truth)) files.push_back(std::move(file));
  return files;
}

Result<MapTruth> read_map_truth(const std::filesystem::path& building) {
  const std::filesystem::path run = building.parent_path() / kTrip,
                              truth = building.parent_path() / kTripTruth;
  if (!std::filesystem::exists(run) || !std::filesystem::exists(truth)) return MapTruth();
  auto thought = read_tum(run);
  if (!thought) return thought.problems();
  auto real = read_tum(truth);
  if (!real) return real.problems();
  if (thought->T_map_vehicle.size() != real->T_map_vehicle.size()) return MapTruth();
  return MapTruth(std::move(thought->T_map_vehicle), std::move(real->T_map_vehicle));
}

}  // namespace aisle
