#pragma once
/// The files that learning and refining write into a directory, and how driving reads them.

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/commands/output_directory.hpp"
#include "aisle/core/result.hpp"
#include "aisle/evaluation/map_truth.hpp"
#include "aisle/maps/building.hpp"

namespace aisle {

std::vector<std::string> learned_file_names();

/// How the map lies in the simulated world, for evaluation: trip.tum and trip_truth.tum.
std::vector<std::string> truth_file_names();
std::vector<OutputFile> truth_files(const MapTruth& truth);

/// building.json; landmarks.svg with the landmarks, the routes and the run; and truth_files(), empty if there
/// is no truth.
/// @param p_map_sightings  drawn, too
std::vector<OutputFile> learned_files(const Building& building, const MapTruth& truth,
                                      const std::vector<Vec2>& p_map_sightings);

/// Reads the truth files beside a building file.
/// @return empty if there are none
Result<MapTruth> read_map_truth(const std::filesystem::path& building);

}  // namespace aisle
