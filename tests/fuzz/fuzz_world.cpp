#include <string>

#include "aisle/formats/worlds/world_yaml.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto world = parse_world(std::string(fuzz_text(bytes, size)), "input");
  if (world.ok()) (void)parse_world(world_yaml(*world), "written");
  return 0;
}
