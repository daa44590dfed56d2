#include "buildings/route_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "aisle/core/angle.hpp"
#include "aisle/formats/buildings/section_text.hpp"
#include "buildings/json_text.hpp"
#include "buildings/landmark_json.hpp"
#include "buildings/room_json.hpp"

namespace aisle {
namespace {

// Rounding errors add up along a route: ten thousand pieces of 0.1 m must still end within a millimetre.
constexpr int kPathDecimals_m = 7;
constexpr int kPathDecimals_deg = 8;

constexpr std::size_t kRoutesMax = 1000;
constexpr std::size_t kPiecesMax = 100'000;
constexpr std::size_t kSectionsMax = 10'000;
constexpr std::size_t kStartViewMax = 10'000;
constexpr double kPieceLengthMin_m = 0.001;  // of at least one piece, so that a route leads somewhere
constexpr double kRouteLengthMax_m = 100'000;
constexpr double kTurnMax_deg = 3600;

bool leads_somewhere(const Path& path) {
  return std::any_of(path.pieces().begin(), path.pieces().end(),
                     [](const PathPiece& piece) { return piece.path_m() >= kPieceLengthMin_m; });
}

std::string heading_text(double heading_rad) {
  std::string text = decimals(to_degrees(wrap_angle(heading_rad)), kPathDecimals_deg);
  return text == "180" ? "-180" : text;
}

/// Empty if the piece is too short to be written.
std::string piece_json(const Arc& arc) {
  const std::string length_m = decimals(arc.length_m, kPathDecimals_m);
  const std::string turn_deg = decimals(to_degrees(arc.turn_rad), kPathDecimals_deg);
  if (length_m == "0" && turn_deg == "0") return "";
  return fmt::format(R"({{"length_m": {}, "turn_deg": {}}})", length_m, turn_deg);
}

std::string pieces_json(const Path& path) {
  std::vector<std::string> pieces;
  for (const PathPiece& piece : path.pieces()) {
    std::string text = piece_json(piece.arc);
    if (!text.empty()) pieces.push_back(std::move(text));
  }
  return list_json(pieces);
}

std::string sections_json(const SectionList& sections) {
  std::vector<std::string> lines;
  lines.reserve(sections.size());
  for (const Section& section : sections) lines.push_back(quoted_json(section_text(section)));
  return list_json(lines);
}

std::string start_view_json(const std::vector<StartSighting>& view) {
  std::vector<std::string> sightings;
  sightings.reserve(view.size());
  for (const StartSighting& sighting : view) {
    sightings.push_back(fmt::format(R"({{"at_m": {}, "brighter": "{}"}})",
                                    point_json(sighting.p_vehicle, kMillimetreDecimals),
                                    brighter_text(sighting.brighter_right)));
  }
  return list_json(sightings);
}

std::string route_json(const Route& route) {
  if (route.name.empty() || !leads_somewhere(route.path))
    throw std::invalid_argument("a route to be written needs a name and a length");
  const Pose2 T_map_start = route.path.at(0).T_map_path;
  const std::string start =
      fmt::format(R"({{"at_m": {}, "heading_deg": {}}})", point_json(T_map_start.position(), kPathDecimals_m),
                  heading_text(T_map_start.theta));
  std::string text = fmt::format(R"({{"name": {}, "start": {}, )", quoted_json(route.name), start) +
                     (route.sections.empty() ? R"("pieces": )" + pieces_json(route.path)
                                             : R"("sections": )" + sections_json(route.sections));
  if (!route.start_view.empty()) text += R"(, "start_view": )" + start_view_json(route.start_view);
  if (route.room) text += R"(, "room": )" + room_json(*route.room);
  return text + "}";
}

Pose2 read_start(const JsonValue& value) {
  if (!value.is_object_of({"at_m", "heading_deg"})) return {};
  Vec2 p_map = Vec2::Zero();
  double heading_deg = 0;
  if (const auto at = value.require("at_m")) at->read_point(p_map);
  if (const auto heading = value.require("heading_deg")) heading->read_number(heading_deg, -360, 360);
  return {p_map.x(), p_map.y(), wrap_angle(heading_deg * kDegree)};
}

Arc read_piece(const JsonValue& value) {
  Arc arc;
  if (!value.is_object_of({"length_m", "turn_deg"})) return arc;
  double turn_deg = 0;
  if (const auto length = value.find("length_m"))
    length->read_number(arc.length_m, -kRouteLengthMax_m, kRouteLengthMax_m);
  if (const auto turn = value.find("turn_deg")) turn->read_number(turn_deg, -kTurnMax_deg, kTurnMax_deg);
  arc.turn_rad = turn_deg * kDegree;
  return arc;
}

Path read_path(const Pose2& T_map_start, const JsonValue& value) {
  if (!value.is_list_up_to(kPiecesMax)) return {};
  std::vector<PathPiece> pieces;
  pieces.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    pieces.push_back({pieces.empty() ? T_map_start : pieces.back().end(), read_piece(value.element(i))});
  }
  Path path(std::move(pieces));
  if (!leads_somewhere(path)) value.wrong("have no piece of a millimetre or more");
  if (path.length_m() > kRouteLengthMax_m)
    value.wrong(fmt::format("are longer than {:g} m in total", kRouteLengthMax_m));
  return path;
}

/// Appends the section that a text describes. @return false if it describes none
bool read_section(const JsonValue& text, SectionList& sections) {
  std::string line;
  text.read(line);
  const auto section = parse_section(line);
  if (!section) {
    text.wrong(section.problems().front().what);
    return false;
  }
  sections.push_back(*section);
  return true;
}

SectionList read_sections(const JsonValue& value) {
  SectionList sections;
  if (!value.is_list_up_to(kSectionsMax)) return sections;
  bool is_good = true;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const JsonValue element = value.element(i);
    is_good = element.is_text() && read_section(element, sections) && is_good;
  }
  if (!is_good) return {};
  for (const SectionFault& fault : section_faults(sections)) {
    if (sections.empty())
      value.wrong(fault.what);
    else
      value.element(fault.section).wrong(fault.what);
    is_good = false;
  }
  return is_good ? sections : SectionList();
}

std::vector<StartSighting> read_start_view(const JsonValue& value) {
  std::vector<StartSighting> view;
  if (!value.is_list_up_to(kStartViewMax)) return view;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const JsonValue element = value.element(i);
    StartSighting& sighting = view.emplace_back();
    if (!element.is_object_of({"at_m", "brighter"})) continue;
    if (const auto at = element.require("at_m")) at->read_point(sighting.p_vehicle);
    if (const auto brighter = element.require("brighter")) read_brighter(*brighter, sighting.brighter_right);
  }
  return view;
}

Route read_route(const JsonValue& value) {
  Route route;
  if (!value.is_object_of({"name", "start", "pieces", "sections", "start_view", "room"})) return route;
  Pose2 T_map_start;
  if (const auto name = value.require("name")) name->read_name(route.name);
  if (const auto start = value.require("start")) T_map_start = read_start(*start);
  if (const auto sections = value.find("sections")) {
    route.sections = read_sections(*sections);
    if (!route.sections.empty()) route.path = path_of(route.sections, T_map_start);
    if (const auto pieces = value.find("pieces"))
      pieces->wrong("cannot be combined with sections, which already give the path");
  } else if (const auto pieces = value.require("pieces")) {
    route.path = read_path(T_map_start, *pieces);
  }
  if (const auto view = value.find("start_view")) route.start_view = read_start_view(*view);
  if (const auto room = value.find("room")) route.room = read_room(*room);
  return route;
}

void check_names(const std::vector<Route>& routes, const JsonValue& value) {
  std::map<std::string, std::size_t> first_of_name;
  for (std::size_t i = 0; i < routes.size(); ++i) {
    const auto [first, is_new] = first_of_name.emplace(routes[i].name, i);
    const auto name = value.element(i).find("name");
    if (!is_new && name && !routes[i].name.empty())
      name->wrong(fmt::format("is the name of routes[{}] too", first->second));
  }
}

}  // namespace

std::string routes_json(const std::vector<Route>& routes) {
  std::vector<std::string> texts;
  texts.reserve(routes.size());
  for (const Route& route : routes) texts.push_back(route_json(route));
  return list_json(texts);
}

std::vector<Route> read_routes(const JsonValue& value) {
  std::vector<Route> routes;
  if (!value.is_list_up_to(kRoutesMax)) return routes;
  for (std::size_t i = 0; i < value.size(); ++i) routes.push_back(read_route(value.element(i)));
  check_names(routes, value);
  return routes;
}

}  // namespace aisle
