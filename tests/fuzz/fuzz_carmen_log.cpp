#include "aisle/formats/logs/carmen_log.hpp"
#include "fuzz_recording.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  for (const LengthUnit unit : {LengthUnit::kMetre, LengthUnit::kCentimetre, LengthUnit::kMillimetre}) {
    RecordingOptions options;
    options.unit = unit;
    const auto carmen = parse_carmen_log(fuzz_text(bytes, size), "input", options);
    if (carmen.ok()) check_recording_promises(*carmen);
  }
  return 0;
}
