#include "aisle/formats/sessions/session_origin.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "aisle/formats/json_document.hpp"

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSessionFormat = "aisle.session";
constexpr int kSessionVersion = 1;

}  // namespace

std::string session_origin_json(const SessionOrigin& origin) {
  Json json = {{"format", kSessionFormat},      {"version", kSessionVersion},
               {"navigator", origin.navigator}, {"parameters", origin.parameters},
               {"seed", origin.seed},           {"simulated", origin.simulated}};
  if (!origin.building.empty()) json["building"] = origin.building;
  if (!origin.route.empty()) json["route"] = origin.route;
  if (origin.in_reverse) json["in_reverse"] = true;
  if (!origin.has_odometry) json["odometry"] = false;
  if (!origin.has_calibration) json["calibration"] = false;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<SessionOrigin> parse_session_origin(std::string_view text, const std::string& name) {
  const Result<Json> document = parse_json<Json>(text, name);
  if (!document) return document.problems();
  const Json& json = *document;
  try {
    if (json.at("format") != kSessionFormat) return Problem{{name, 0, "format"}, "is not an aisle session"};
    if (const Json& version = json.at("version"); version != kSessionVersion) {
      return Problem{{name, 0, "version"},
                     fmt::format("{} is unknown; this program reads {}", version.dump(), kSessionVersion)};
    }
    if (!json.at("seed").is_number_unsigned())
      return Problem{{name, 0, "seed"}, "is not a whole number from 0 on"};
    return SessionOrigin{.navigator = json.at("navigator").get<std::string>(),
                         .parameters = json.at("parameters").get<std::map<std::string, std::string>>(),
                         .seed = json.at("seed").get<std::uint64_t>(),
                         .simulated = json.at("simulated").get<bool>(),
                         .building = json.value("building", ""),
                         .route = json.value("route", ""),
                         .in_reverse = json.value("in_reverse", false),
                         .has_odometry = json.value("odometry", true),
                         .has_calibration = json.value("calibration", true)};
  } catch (const Json::exception&) {
    return Problem{{name}, "does not say what made the session"};
  }
}

}  // namespace aisle
