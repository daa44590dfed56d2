#include <fmt/format.h>

#include <array>
#include <cmath>

#include "buildings/building_parts.hpp"

namespace aisle {
namespace {

constexpr std::size_t kZonesMax = 200, kZoneCornersMax = 100;  // all are looked at in every cycle
constexpr Range kZoneSpeed_mps = {0.01, 20};
constexpr double kZoneAreaMin_m2 = 1e-4;
constexpr std::array<std::string_view, 3> kZoneKinds = {"keep_out", "slow", "one_way"};

/// Reading, the kind is not known before the other keys.
enum class ZoneKeys { kAll, kOfKind };

JsonFields zone_fields(Zone& zone, ZoneKeys keys) {
  const bool all = keys == ZoneKeys::kAll;
  JsonFields fields = {needed(field::word("kind", zone.kind, kZoneKinds)),
                       needed(field::points("outline_m", zone.outline, kMapCoordinate_m))};
  if (all || !zone.name.empty()) fields.push_back(field::text("name", zone.name));
  if (all || zone.kind == Zone::Kind::kSlow)
    fields.push_back(field::number("speed_max_mps", zone.speed_max_mps, kZoneSpeed_mps));
  if (all || zone.kind == Zone::Kind::kOneWay)
    fields.push_back(field::angle("direction_deg", zone.direction_rad));
  return fields;
}

/// By the shoelace formula; 0 where an outline crosses itself evenly.
double area_m2(const std::vector<Vec2>& outline) {
  double twice_m2 = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &p = outline[i], &q = outline[(i + 1) % outline.size()];
    twice_m2 += p.x() * q.y() - p.y() * q.x();
  }
  return std::abs(twice_m2) / 2;
}

void check_outline(const std::vector<Vec2>& outline, const JsonValue& value) {
  if (outline.size() < 3 || outline.size() > kZoneCornersMax)
    value.wrong(fmt::format("must have 3 to {} corners", kZoneCornersMax));
  else if (area_m2(outline) < kZoneAreaMin_m2)
    value.wrong("encloses no area");
}

/// A key that one kind of zone needs, and that means nothing to the others.
void check_key(const JsonValue& value, const char* key, bool is_of_kind) {
  if (is_of_kind)
    value.require(key);
  else if (const auto member = value.find(key))
    member->wrong("means nothing in a zone of this kind");
}

Zone read_zone(const JsonValue& value) {
  Zone zone;
  if (!read_object(value, zone_fields(zone, ZoneKeys::kAll))) return zone;
  if (const auto outline = value.find("outline_m")) check_outline(zone.outline, *outline);
  check_key(value, "speed_max_mps", zone.kind == Zone::Kind::kSlow);
  check_key(value, "direction_deg", zone.kind == Zone::Kind::kOneWay);
  return zone;
}

std::string zone_json(Zone& zone) {
  return object_json(zone_fields(zone, ZoneKeys::kOfKind));
}

}  // namespace

JsonPart zones_part(std::string_view key, std::vector<Zone>& zones) {
  return list_part(key, zones, kZonesMax, zone_json, read_zone);
}

}  // namespace aisle
