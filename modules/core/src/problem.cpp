#include "aisle/core/problem.hpp"

namespace aisle {

Problems at_file(Problems problems, const std::string& file) {
  for (Problem& problem : problems) problem.where.file = file;
  return problems;
}

std::string to_string(const Problem& problem) {
  std::string text;
  if (!problem.where.file.empty()) {
    text += problem.where.file;
    if (problem.where.line > 0) text += ":" + std::to_string(problem.where.line);
    text += ": ";
  }
  if (!problem.where.key.empty()) text += problem.where.key + ": ";
  return text + problem.what;
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
