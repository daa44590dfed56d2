#include "aisle/formats/worlds/world_yaml.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto world = parse_wall_segments(fuzz_text(bytes, size), "input");
  if (world.ok()) require(!world->walls.empty());
  return 0;
}
