#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

/// --connect: the robot that is driven, instead of a simulated vehicle.
/// @param simulated_only  options of the verb that make no sense with it; they stand before it
void add_robot(CLI::App& verb, std::filesystem::path& connection,
               const std::vector<std::string>& simulated_only);

/// Refuses a command line with neither world nor robot.
void require_vehicle(const std::string& world, const std::filesystem::path& connection);
