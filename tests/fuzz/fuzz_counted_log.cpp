#include "aisle/formats/logs/counted_log.hpp"
#include "fuzz_recording.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(fuzz_text(bytes, size));
  (void)begins_coreslam_log(text);
  (void)begins_lego_log(text);
  if (const auto recording = parse_coreslam_log(text, "input"); recording.ok())
    check_recording_promises(*recording);
  if (const auto recording = parse_lego_log({{text}}, "input"); recording.ok())
    check_recording_promises(*recording);
  return 0;
}
