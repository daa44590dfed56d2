#include "aisle/formats/buildings/floor_marks.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto marks = parse_floor_marks(fuzz_text(bytes, size), "input");
  require(!marks || marks->size() >= kFloorMarksMin);
  return 0;
}
