#include "aisle/formats/images/cell_map.hpp"

#include "aisle/formats/images/bee_map.hpp"
#include "aisle/formats/images/map_server.hpp"
#include "aisle/formats/whole_file.hpp"
#include "file_limits.hpp"
#include "unpacked_file.hpp"

namespace aisle {

Result<PlanReading> read_cell_map(const std::filesystem::path& path) {
  const Result<std::string> head = read_unpacked_head(path, kBeeMapHead);
  if (!head || !begins_bee_map(*head)) return read_map_server(path);
  const Result<std::string> text = read_whole_file(path, kPlanBytesMax);
  if (!text) return text.problems();
  return parse_bee_map(*text, path.string());
}

}  // namespace aisle
