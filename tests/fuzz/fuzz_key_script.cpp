#include "aisle/formats/key_script_text.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto keys = parse_key_script(fuzz_text(bytes, size), "input");
  if (!keys.ok()) return 0;
  require(!keys->empty());
  for (const TimedKey& timed : *keys) require(timed.from_s >= 0 && timed.to_s >= timed.from_s);
  return 0;
}
