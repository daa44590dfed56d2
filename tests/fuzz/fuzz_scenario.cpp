#include <string>

#include "aisle/formats/worlds/scenario_yaml.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto scenario = parse_scenario(std::string(fuzz_text(bytes, size)), "input");
  if (!scenario.ok()) return 0;
  for (const ScenarioEvent& event : scenario->events) {
    require(event.from_s >= 0 && event.duration_s > 0);
    const auto* crossing = std::get_if<CrossingPerson>(&event.fault);
    require(crossing == nullptr || crossing->person.path.size() >= 2);
  }
  return 0;
}
