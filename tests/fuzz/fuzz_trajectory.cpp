#include "aisle/formats/logs/read_poses.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (const auto table = parse_pose_csv(fuzz_text(bytes, size), "input"); table.ok())
    require(table->stamps_s.size() == table->T_map_vehicle.size());
  const auto trajectory = parse_tum(fuzz_text(bytes, size), "input");
  if (!trajectory.ok()) return 0;
  require(trajectory->stamps_s.size() == trajectory->T_map_vehicle.size());
  require(parse_tum(tum_text(trajectory->stamps_s, trajectory->T_map_vehicle), "written").ok());
  return 0;
}
