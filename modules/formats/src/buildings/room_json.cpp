#include "buildings/room_json.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <string_view>

#include "aisle/vision/places/column_view.hpp"
#include "buildings/json_text.hpp"

namespace aisle {
namespace {

constexpr int kGreyDecimals = 2, kViewDecimals = 4;
constexpr std::size_t kTurningsMax = 1000, kViewsMax = 10'000, kEdgesMax = 100'000;
constexpr double kPathMax_m = 100'000, kFrameMax_m = 20, kFrameMin_m = 0.2, kGreyMax = 255;

std::string turning_json(const RoomTurning& turning) {
  return fmt::format(R"({{"number": {}, "start_m": {}, "end_m": {}}})", turning.number,
                     decimals(turning.start_m, kMillimetreDecimals),
                     decimals(turning.end_m, kMillimetreDecimals));
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

std::string view_json(const StopView& view) {
  std::string shares;
  for (const double share : view.seen.brightness)
    shares += (shares.empty() ? "[" : ", ") + decimals(share, kViewDecimals);
  std::string text =
      fmt::format(R"({{"left_m": {}, "at": {}])", decimals(view.left_m, kMillimetreDecimals), shares);
  if (!view.seen.columns.bytes.empty()) text += R"(, "columns": )" + columns_json(view.seen.columns);
  return text + "}";
}

std::string edge_json(const RouteEdge& edge) {
  return fmt::format("[{}, {}, {}]", decimals(edge.along_m, kMillimetreDecimals),
                     decimals(edge.p_map.x(), kMillimetreDecimals),
                     decimals(edge.p_map.y(), kMillimetreDecimals));
}

template <class Item, class Text>
std::string list_of(const std::vector<Item>& items, const Text& text) {
  std::vector<std::string> texts;
  texts.reserve(items.size());
  for (const Item& item : items) texts.push_back(text(item));
  return list_json(texts);
}

RouteBrightness read_brightness(const JsonValue& value) {
  RouteBrightness brightness;
  if (!value.is_object_of({"grey", "deviation"})) return brightness;
  if (const auto grey = value.require("grey")) grey->read_number(brightness.grey, 0, kGreyMax);
  if (const auto deviation = value.require("deviation"))
    deviation->read_number(brightness.deviation, 0, kGreyMax);
  return brightness;
}

RoomTurning read_turning(const JsonValue& value) {
  RoomTurning turning;
  if (!value.is_object_of({"number", "start_m", "end_m"})) return turning;
  if (const auto number = value.require("number")) number->read_count(turning.number, 1, kTurningNumbers);
  if (const auto start = value.require("start_m")) start->read_number(turning.start_m, 0, kPathMax_m);
  if (const auto end = value.require("end_m")) {
    end->read_number(turning.end_m, 0, kPathMax_m);
    if (turning.end_m < turning.start_m) end->wrong("is before start_m");
  }
  return turning;
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

StopView read_view(const JsonValue& value) {
  StopView view;
  if (!value.is_object_of({"left_m", "at", "columns"})) return view;
  if (const auto columns = value.find("columns")) view.seen.columns = read_columns(*columns);
  if (const auto left = value.require("left_m")) left->read_number(view.left_m, -kPathMax_m, kPathMax_m);
  const auto at = value.require("at");
  if (!at || !at->is_list_of(view.seen.brightness.size())) return view;
  for (std::size_t i = 0; i < view.seen.brightness.size(); ++i)
    at->element(i).read_number(view.seen.brightness[i], 0, 1);
  return view;
}

RouteEdge read_edge(const JsonValue& value) {
  RouteEdge edge;
  if (!value.is_list_of(3)) return edge;
  value.element(0).read_number(edge.along_m, 0, kPathMax_m);
  value.element(1).read_number(edge.p_map.x(), -kPathMax_m, kPathMax_m);
  value.element(2).read_number(edge.p_map.y(), -kPathMax_m, kPathMax_m);
  return edge;
}

void read_parking(const JsonValue& value, ParkingStrategy& parking) {
  for (std::size_t i = 0; i < kParkingWords.size(); ++i) {
    if (!value.is(kParkingWords[i])) continue;
    parking = static_cast<ParkingStrategy>(i);
    return;
  }
  value.wrong("is none of \"frame\", \"dead-end\", \"view\"");
}

}  // namespace

std::string room_json(const RoomRoute& room) {
  std::string text =
      fmt::format(R"({{"brightness": {{"grey": {}, "deviation": {}}}, "parking": "{}")",
                  decimals(room.brightness.grey, kGreyDecimals),
                  decimals(room.brightness.deviation, kGreyDecimals), parking_word(room.parking));
  if (room.parking == ParkingStrategy::kFrame)
    text += R"(, "frame_size_m": )" + point_json(room.frame_size_m, kMillimetreDecimals);
  if (!room.turnings.empty()) text += R"(, "turnings": )" + list_of(room.turnings, turning_json);
  if (!room.views.empty()) text += R"(, "views": )" + list_of(room.views, view_json);
  if (!room.edges.empty()) text += R"(, "edges": )" + list_of(room.edges, edge_json);
  return text + "}";
}

RoomRoute read_room(const JsonValue& value) {
  RoomRoute room;
  if (!value.is_object_of({"brightness", "parking", "frame_size_m", "turnings", "views", "edges"}))
    return room;
  if (const auto brightness = value.require("brightness")) room.brightness = read_brightness(*brightness);
  if (const auto parking = value.require("parking")) read_parking(*parking, room.parking);
  if (room.parking == ParkingStrategy::kFrame) {
    if (const auto size = value.require("frame_size_m"); size && size->is_list_of(2)) {
      size->element(0).read_number(room.frame_size_m.x(), kFrameMin_m, kFrameMax_m);
      size->element(1).read_number(room.frame_size_m.y(), kFrameMin_m, kFrameMax_m);
    }
  } else if (const auto size = value.find("frame_size_m")) {
    size->wrong("is for the parking \"frame\" alone");
  }
  if (const auto turnings = value.find("turnings"); turnings && turnings->is_list_up_to(kTurningsMax)) {
    for (std::size_t i = 0; i < turnings->size(); ++i)
      room.turnings.push_back(read_turning(turnings->element(i)));
  }
  if (const auto views = value.find("views"); views && views->is_list_up_to(kViewsMax)) {
    for (std::size_t i = 0; i < views->size(); ++i) room.views.push_back(read_view(views->element(i)));
  }
  if (const auto edges = value.find("edges"); edges && edges->is_list_up_to(kEdgesMax)) {
    for (std::size_t i = 0; i < edges->size(); ++i) room.edges.push_back(read_edge(edges->element(i)));
  }
  return room;
}

}  // namespace aisle
