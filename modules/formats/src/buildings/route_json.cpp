#include "buildings/building_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "aisle/formats/buildings/section_text.hpp"

namespace aisle {
namespace {

// Rounding errors add up along a route: ten thousand pieces of 0.1 m must still end within a millimetre.
constexpr Digits kPathDigits_m = {7};
constexpr Digits kPathDigits_deg = {8};

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

JsonFields start_fields(Pose2& T_map_start) {
  return {needed(field::point("at_m", T_map_start.x, T_map_start.y, kMapCoordinate_m, kPathDigits_m)),
          needed(heading_part("heading_deg", T_map_start.theta, kPathDigits_deg.count))};
}

JsonFields piece_fields(Arc& piece) {
  return {field::number("length_m", piece.length_m, {-kRouteLengthMax_m, kRouteLengthMax_m}, kPathDigits_m),
          field::angle("turn_deg", piece.turn_rad, {-kTurnMax_deg, kTurnMax_deg}, kPathDigits_deg)};
}

JsonFields sighting_fields(StartSighting& sighting) {
  return {needed(field::point("at_m", sighting.p_vehicle, kMapCoordinate_m)),
          needed(brighter_field("brighter", sighting.brighter_right))};
}

/// Without the pieces that are too short to be written.
std::string pieces_json(const Path& path) {
  Arc arc;
  const JsonFields fields = piece_fields(arc);
  const std::string nothing = object_json(fields);
  std::vector<std::string> pieces;
  for (const PathPiece& piece : path.pieces()) {
    arc = piece.arc;
    if (std::string text = object_json(fields); text != nothing) pieces.push_back(std::move(text));
  }
  return list_json(pieces);
}

std::string sections_json(const SectionList& sections) {
  std::vector<std::string> lines;
  lines.reserve(sections.size());
  for (const Section& section : sections) lines.push_back(quoted_json(section_text(section)));
  return list_json(lines);
}

Path read_path(const Pose2& T_map_start, const JsonValue& value) {
  if (!value.is_list_up_to(kPiecesMax)) return {};
  std::vector<PathPiece> pieces;
  pieces.reserve(value.size());
  for (std::size_t i = 0; i < value.size(); ++i) {
    pieces.push_back({pieces.empty() ? T_map_start : pieces.back().end(), Arc()});
    read_object(value.element(i), piece_fields(pieces.back().arc));
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

constexpr const char* kSectionsKey = "sections";
constexpr const char* kPiecesKey = "pieces";

/// The path is that of the sections or of the pieces; both start at `T_map_start`, which is read before.
JsonFields route_fields(Route& route, Pose2& T_map_start) {
  return {
      needed(field::text("name", route.name)),
      needed(object_part("start", T_map_start, start_fields)),
      JsonPart{kPiecesKey, [&] { return route.sections.empty() ? pieces_json(route.path) : std::string(); },
               [&](const JsonValue& value) { route.path = read_path(T_map_start, value); }},
      JsonPart{kSectionsKey,
               [&] { return route.sections.empty() ? std::string() : sections_json(route.sections); },
               [&](const JsonValue& value) {
                 route.sections = read_sections(value);
                 if (!route.sections.empty()) route.path = path_of(route.sections, T_map_start);
               }},
      unless_empty(objects_part("start_view", route.start_view, kStartViewMax, sighting_fields)),
      room_part("room", route.room)};
}

std::string route_json(Route& route) {
  if (route.name.empty() || !leads_somewhere(route.path))
    throw std::invalid_argument("a route to be written needs a name and a length");
  Pose2 T_map_start = route.path.at(0).T_map_path;
  return object_json(route_fields(route, T_map_start));
}

Route read_route(const JsonValue& value) {
  Route route;
  Pose2 T_map_start;
  if (!read_object(value, route_fields(route, T_map_start))) return route;
  if (!value.find(kSectionsKey)) {
    value.require(kPiecesKey);
  } else if (const auto pieces = value.find(kPiecesKey)) {
    pieces->wrong("cannot be combined with sections, which already give the path");
  }
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

JsonPart routes_part(std::string_view key, std::vector<Route>& routes) {
  JsonPart part = list_part(key, routes, kRoutesMax, route_json, read_route);
  part.read = [read = std::move(part.read), &routes](const JsonValue& value) {
    read(value);
    check_names(routes, value);
  };
  return part;
}

}  // namespace aisle
