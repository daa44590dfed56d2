#include "aisle/formats/logs/carmen_log.hpp"

#include "logs/carmen_parser.hpp"
#include "logs/unpacked_file.hpp"

namespace aisle {

Result<LaserRecording> parse_carmen_log(std::string_view text, const std::string& name,
                                        const RecordingOptions& options) {
  if (text.empty()) return Problem{{name}, "is empty"};
  return CarmenParser(name, options).parse(text);
}

Result<LaserRecording> read_carmen_log(const std::filesystem::path& path, const RecordingOptions& options) {
  const Result<UnpackedFile> file = read_unpacked_file(path);
  if (!file) return file.problems();
  Result<LaserRecording> recording = parse_carmen_log(file->bytes, path.string(), options);
  if (recording && !file->damage.empty()) {
    recording->warnings.push_back({{path.string()}, file->damage + "; what comes before is used"});
  }
  return recording;
}

}  // namespace aisle
