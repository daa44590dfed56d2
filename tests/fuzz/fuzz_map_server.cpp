#include "aisle/formats/images/map_server.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto map = parse_map_server_yaml(std::string(fuzz_text(bytes, size)), "input");
  if (!map.ok()) {
    require(!map.problems().empty());
    return 0;
  }
  TransparentImage greys{Image(16, 16), {}};
  for (std::size_t i = 0; i < greys.image.bytes.size(); ++i)
    greys.image.bytes[i] = static_cast<std::uint8_t>(i);
  require(plan_of_map(greys, *map).plan.solid.size() == greys.image.bytes.size());
  require(!map->image.empty() && map->resolution_m > 0 && map->T_map_plan.is_finite());
  return 0;
}
