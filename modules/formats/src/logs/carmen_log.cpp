#include "aisle/formats/logs/carmen_log.hpp"

#include "logs/carmen_parser.hpp"

namespace aisle {

Result<LaserRecording> parse_carmen_log(std::string_view text, const std::string& name,
                                        const RecordingOptions& options) {
  if (text.empty()) return Problem{{name}, "is empty"};
  return CarmenParser(name, options).parse(text);
}

}  // namespace aisle
