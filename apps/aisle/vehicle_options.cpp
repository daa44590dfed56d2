#include "vehicle_options.hpp"

void add_robot(CLI::App& verb, std::filesystem::path& connection,
               const std::vector<std::string>& simulated_only) {
  CLI::Option* const option =
      verb.add_option("--connect", connection, "connection file (YAML) of a robot: not simulated");
  for (const std::string& name : simulated_only) option->excludes(verb.get_option(name));
}

void require_vehicle(const std::string& world, const std::filesystem::path& connection) {
  if (world.empty() && connection.empty()) throw CLI::RequiredError("a world or --connect");
}
