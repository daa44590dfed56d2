#include "aisle/commands/outcome.hpp"

namespace aisle {

nlohmann::ordered_json warnings_json(const Problems& warnings) {
  auto json = nlohmann::ordered_json::array();
  for (const Problem& warning : warnings)
    json.push_back({{"where", to_string(warning.where)}, {"what", warning.what}});
  return json;
}

void warn_of(const Problems& warnings, const Console& console) {
  for (const Problem& warning : warnings) console.warn(to_string(warning));
}

std::string to_json(const Outcome& outcome) {
  nlohmann::ordered_json json = {
      {"verb", outcome.verb}, {"ok", outcome.ok}, {"figures", outcome.figures}, {"files", outcome.files}};
  if (!outcome.problems.empty()) json["problems"] = warnings_json(outcome.problems);
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace aisle
