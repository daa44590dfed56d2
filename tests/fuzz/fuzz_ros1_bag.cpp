#include "fuzz_bag.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  aisle::read_as_bag(".bag", bytes, size);
  return 0;
}
