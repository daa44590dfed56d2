#include "buildings/building_parts.hpp"

#include <fmt/format.h>

#include <charconv>

#include "aisle/vision/places/column_view.hpp"

namespace aisle {
namespace {

constexpr std::size_t kTurningsMax = 1000, kViewsMax = 10'000, kEdgesMax = 100'000;
constexpr double kPathMax_m = 100'000;
constexpr Range kAlong_m = {0, kPathMax_m}, kFarAway_m = {-kPathMax_m, kPathMax_m};
constexpr Range kFrame_m = {0.2, 20}, kGreyLevel = {0, 255};
constexpr Digits kGreyDigits = {2}, kViewDigits = {4};
constexpr const char* kFrameSizeKey = "frame_size_m";

JsonFields brightness_fields(RouteBrightness& brightness) {
  return {needed(field::number("grey", brightness.grey, kGreyLevel, kGreyDigits)),
          needed(field::number("deviation", brightness.deviation, kGreyLevel, kGreyDigits))};
}

JsonFields turning_fields(RoomTurning& turning) {
  return {needed(field::count("number", turning.number, {1, kTurningNumbers})),
          needed(field::number("start_m", turning.start_m, kAlong_m)),
          needed(field::number("end_m", turning.end_m, kAlong_m))};
}

RoomTurning read_turning(const JsonValue& value) {
  RoomTurning turning;
  if (!read_object(value, turning_fields(turning))) return turning;
  if (const auto end = value.find("end_m"); end && turning.end_m < turning.start_m)
    end->wrong("is before start_m");
  return turning;
}

std::string columns_json(const Image& columns) {
  std::string rows;
  for (int v = 0; v < columns.height_px; ++v) {
    rows += rows.empty() ? "[\"" : ", \"";
    for (int u = 0; u < columns.width_px; ++u) rows += fmt::format("{:02x}", columns.row(v)[u]);
    rows += '"';
  }
  return rows + "]";
}

/// Two hexadecimal digits per column of a band.
void read_band(const JsonValue& value, Image& columns, int band) {
  if (!value.is_text()) return;
  std::string digits;
  value.read(digits);
  if (digits.size() != 2 * columns.row_bytes() ||
      digits.find_first_not_of("0123456789abcdef") != std::string::npos)
    return value.wrong(fmt::format("is not {} digits 0-9 and a-f", 2 * columns.row_bytes()));
  for (int u = 0; u < columns.width_px; ++u) {
    const char* const pair = digits.data() + 2 * static_cast<std::size_t>(u);
    std::from_chars(pair, pair + 2, columns.row(band)[u], 16);
  }
}

Image read_columns(const JsonValue& value) {
  Image columns(kViewColumns, kViewBands);
  if (!value.is_list_of(kViewBands)) return {};
  for (int band = 0; band < kViewBands; ++band)
    read_band(value.element(static_cast<std::size_t>(band)), columns, band);
  return columns;
}

JsonPart columns_part(std::string_view key, Image& columns) {
  return {key, [&columns] { return columns.bytes.empty() ? std::string() : columns_json(columns); },
          [&columns](const JsonValue& value) { columns = read_columns(value); }};
}

JsonFields view_fields(StopView& view) {
  PointTarget shares;
  for (double& share : view.seen.brightness) shares.coordinates.push_back(&share);
  return {needed(field::number("left_m", view.left_m, kFarAway_m)),
          needed(ObjectField{.key = "at", .target = shares, .range = {0, 1}, .digits = kViewDigits}),
          columns_part("columns", view.seen.columns)};
}

std::string edge_json(const RouteEdge& edge) {
  return fmt::format("[{}, {}, {}]", decimals(edge.along_m, kMillimetreDecimals),
                     decimals(edge.p_map.x(), kMillimetreDecimals),
                     decimals(edge.p_map.y(), kMillimetreDecimals));
}

RouteEdge read_edge(const JsonValue& value) {
  RouteEdge edge;
  if (!value.is_list_of(3)) return edge;
  value.element(0).read_number(edge.along_m, kAlong_m);
  value.element(1).read_number(edge.p_map.x(), kFarAway_m);
  value.element(2).read_number(edge.p_map.y(), kFarAway_m);
  return edge;
}

JsonPart frame_size_part(std::string_view key, RoomRoute& room) {
  const ObjectField size = field::point(key, room.frame_size_m, kFrame_m);
  return {
      key,
      [&room, size] { return room.parking == ParkingStrategy::kFrame ? field_json(size) : std::string(); },
      [&room, size](const JsonValue& value) {
        if (room.parking != ParkingStrategy::kFrame) return value.wrong("is for the parking \"frame\" alone");
        read_field(value, size);
      }};
}

JsonFields room_fields(RoomRoute& room) {
  return {needed(object_part("brightness", room.brightness, brightness_fields)),
          needed(field::word("parking", room.parking, kParkingWords)),
          frame_size_part(kFrameSizeKey, room),
          unless_empty(list_part(
              "turnings", room.turnings, kTurningsMax,
              [](RoomTurning& turning) { return object_json(turning_fields(turning)); }, read_turning)),
          unless_empty(objects_part("views", room.views, kViewsMax, view_fields)),
          unless_empty(list_part("edges", room.edges, kEdgesMax, edge_json, read_edge))};
}

}  // namespace

JsonPart room_part(std::string_view key, std::optional<RoomRoute>& room) {
  return {key, [&room] { return room ? object_json(room_fields(*room)) : std::string(); },
          [&room](const JsonValue& value) {
            const bool is_object = read_object(value, room_fields(room.emplace()));
            if (is_object && room->parking == ParkingStrategy::kFrame) value.require(kFrameSizeKey);
          }};
}

}  // namespace aisle
