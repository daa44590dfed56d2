#include "aisle/formats/logs/laser_csv.hpp"
#include "fuzz_recording.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto recording = parse_laser_csv(fuzz_text(bytes, size), "input");
  if (recording.ok()) check_recording_promises(*recording);
  return 0;
}
