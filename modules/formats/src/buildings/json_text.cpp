#include "buildings/json_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace aisle {

std::string decimals(double value, int count) {
  std::string text = fmt::format("{:.{}f}", value, count);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string point_json(const Vec2& p, int decimal_count) {
  return fmt::format("[{}, {}]", decimals(p.x(), decimal_count), decimals(p.y(), decimal_count));
}

std::string quoted_json(const std::string& text) {
  const nlohmann::json json = text;
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string list_json(const std::vector<std::string>& elements) {
  if (elements.empty()) return "[\n]";
  return fmt::format("[\n{}\n]", fmt::join(elements, ",\n"));
}

}  // namespace aisle
