#include "aisle/formats/session_origin.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace aisle {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kSessionFormat = "aisle.session";
constexpr int kSessionVersion = 1;

}  // namespace

std::string session_origin_json(const SessionOrigin& origin) {
  const Json json = {{"format", kSessionFormat},      {"version", kSessionVersion},
                     {"navigator", origin.navigator}, {"parameters", origin.parameters},
                     {"seed", origin.seed},           {"simulated", origin.simulated}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<SessionOrigin> parse_session_origin(std::string_view text, const std::string& name) {
  const Json json = Json::parse(text, nullptr, false);
  try {
    if (json.at("format") != kSessionFormat) return Problem{{name, 0, "format"}, "is no aisle session"};
    if (const Json& version = json.at("version"); version != kSessionVersion) {
      return Problem{
          {name, 0, "version"},
          fmt::format("{} is unknown here; this program reads {}", version.dump(), kSessionVersion)};
    }
    return SessionOrigin{.navigator = json.at("navigator").get<std::string>(),
                         .parameters = json.at("parameters").get<std::map<std::string, std::string>>(),
                         .seed = json.at("seed").get<std::uint64_t>(),
                         .simulated = json.at("simulated").get<bool>()};
  } catch (const Json::exception&) {
    return Problem{{name}, "does not say what made the session"};
  }
}

}  // namespace aisle
