#include "aisle/formats/images/bee_map.hpp"
#include "aisle/formats/logs/bee_log.hpp"
#include "fuzz_recording.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(fuzz_text(bytes, size));
  (void)begins_bee_log(text);
  (void)begins_bee_map(text);
  if (const auto recording = parse_bee_log(text, "input"); recording.ok())
    check_recording_promises(*recording);
  if (const auto map = parse_bee_map(text, "input"); map.ok())
    require(map->unseen.size() == map->plan.solid.size());
  return 0;
}
