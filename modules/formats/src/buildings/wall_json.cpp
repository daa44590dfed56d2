#include "buildings/building_parts.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace aisle {
namespace {

constexpr std::size_t kAnyNumberOfWalls = std::numeric_limits<std::size_t>::max();
constexpr std::array<std::string_view, 2> kWallEnds = {"seen", "unknown"};

ObjectField end_field(WallEnd& end) {
  return field::word("", end, kWallEnds);
}

/// [start, end]
JsonPart ends_part(std::string_view key, Wall& wall) {
  return {key,
          [&wall] {
            return fmt::format("[{}, {}]", field_json(end_field(wall.start)),
                               field_json(end_field(wall.end)));
          },
          [&wall](const JsonValue& value) {
            if (!value.is_list_of(2)) return;
            read_field(value.element(0), end_field(wall.start));
            read_field(value.element(1), end_field(wall.end));
          }};
}

/// Left out of a wall that is sure, as all are in the map of one trip.
JsonPart evidence_part(std::string_view key, int& evidence) {
  return {key, [&evidence] { return evidence == kSureEvidence ? "" : std::to_string(evidence); },
          [&evidence](const JsonValue& value) {
            read_field(value, field::count("", evidence, {1, kSureEvidence}));
          }};
}

JsonFields wall_fields(Wall& wall) {
  return {needed(field::point("start_m", wall.segment.start, kMapCoordinate_m)),
          needed(field::point("end_m", wall.segment.end, kMapCoordinate_m)),
          field::flag("orthogonal", wall.is_orthogonal),
          ends_part("ends", wall),
          field::count("sightings", wall.sightings),
          field::number("sigma_m", wall.sigma_m, {0, 1e3}, {4, Digits::Kind::kAllDecimals}),
          evidence_part("evidence", wall.evidence)};
}

}  // namespace

JsonPart walls_part(std::string_view key, WallMap& map) {
  return objects_part(key, map.walls, kAnyNumberOfWalls, wall_fields);
}

}  // namespace aisle
