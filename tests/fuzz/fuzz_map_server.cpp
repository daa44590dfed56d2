#include "aisle/formats/images/map_server.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto map = parse_map_server_yaml(std::string(fuzz_text(bytes, size)), "input");
  if (!map.ok()) {
    require(!map.problems().empty());
    return 0;
  }
  require(!map->image.empty() && map->resolution_m > 0 && map->T_map_plan.is_finite());
  return 0;
}
