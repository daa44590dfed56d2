#include "aisle/formats/buildings/building_json.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto building = parse_building(fuzz_text(bytes, size), "input");
  if (!building.ok()) return 0;
  const auto again = parse_building(building_json(*building), "written");
  require(again.ok() && again->walls.walls.size() == building->walls.walls.size());
  require(again->landmarks.size() == building->landmarks.size());
  require(again->routes.size() == building->routes.size());
  return 0;
}
