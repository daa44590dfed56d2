#include <string>

#include "aisle/formats/worlds/vehicle_yaml.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto vehicle = parse_vehicle(std::string(fuzz_text(bytes, size)), "input");
  if (!vehicle.ok()) return 0;
  const std::string text = vehicle_yaml(*vehicle);
  const auto again = parse_vehicle(text, "written");
  require(again.ok() && vehicle_yaml(*again) == text);
  return 0;
}
