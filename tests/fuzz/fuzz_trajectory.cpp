#include "aisle/formats/logs/trajectory.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto trajectory = parse_tum(fuzz_text(bytes, size), "input");
  if (!trajectory.ok()) return 0;
  require(trajectory->stamps_s.size() == trajectory->T_map_vehicle.size());
  require(parse_tum(tum_text(trajectory->stamps_s, trajectory->T_map_vehicle), "written").ok());
  return 0;
}
