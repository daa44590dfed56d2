#include "aisle/core/problem.hpp"

namespace aisle {

std::string to_string(const Place& place) {
  std::string text = place.file;
  if (!text.empty() && place.line > 0) text += ":" + std::to_string(place.line);
  if (!text.empty() && !place.key.empty()) text += ": ";
  return text + place.key;
}

Problems at_file(Problems problems, const std::string& file) {
  for (Problem& problem : problems) problem.where.file = file;
  return problems;
}

std::string to_string(const Problem& problem) {
  const std::string where = to_string(problem.where);
  return where.empty() ? problem.what : where + ": " + problem.what;
}

std::string to_string(const Problems& problems) {
  std::string text;
  for (const Problem& problem : problems) {
    if (!text.empty()) text += '\n';
    text += to_string(problem);
  }
  return text;
}

}  // namespace aisle
