#include <string>

#include "aisle/formats/connections/connection_file.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto connection = parse_connection(std::string(fuzz_text(bytes, size)), "input");
  if (!connection.ok()) return 0;
  const std::string text = connection_yaml(*connection);
  const auto again = parse_connection(text, "written");
  require(again.ok() && connection_yaml(*again) == text);
  return 0;
}
