#include "aisle/commands/outcome.hpp"

namespace aisle {

std::string to_json(const Outcome& outcome) {
  const nlohmann::ordered_json json = {
      {"verb", outcome.verb}, {"ok", outcome.ok}, {"figures", outcome.figures}, {"files", outcome.files}};
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace aisle
