#pragma once
/// The files that learning and refining leave in a directory, and how driving finds them again.

#include <filesystem>
#include <string>
#include <vector>

#include "aisle/commands/output_directory.hpp"
#include "aisle/core/result.hpp"
#include "aisle/maps/building.hpp"
#include "landmarks/landmark_evaluation.hpp"

namespace aisle {

std::vector<std::string> learned_file_names();

/// How the map lies in the simulated world, for evaluation: trip.tum and run_truth.tum.
std::vector<std::string> truth_file_names();
std::vector<OutputFile> truth_files(const MapTruth& truth);

/// building.json; landmarks.svg, the landmarks with the routes and the run; and how the map lies in the
/// simulated world (truth_files; empty files where there is no truth).
/// @param p_map_sightings  drawn, too
std::vector<OutputFile> learned_files(const Building& building, const MapTruth& truth,
                                      const std::vector<Vec2>& p_map_sightings);

/// The truth beside a building's file.
/// @return empty if there is none
Result<MapTruth> read_map_truth(const std::filesystem::path& building);

/// Problems of what a file holds, said of that file.
Problems at_file(Problems problems, const std::string& file);

}  // namespace aisle
