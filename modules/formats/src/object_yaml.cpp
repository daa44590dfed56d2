#include "object_yaml.hpp"

#include <cmath>

#include "yaml_text.hpp"

namespace aisle {
namespace {

constexpr std::size_t kPointsInALine = 6;

/// Rounded to a thousandth of the unit: millimetres, millidegrees.
std::string rounded(double value) {
  return fmt::format("{}", std::round(value * 1000) / 1000 + 0.0);  // + 0.0: never "-0"
}

std::string point_text(const std::vector<double>& coordinates) {
  std::vector<std::string> texts;
  texts.reserve(coordinates.size());
  for (const double value : coordinates) texts.push_back(rounded(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

}  // namespace

std::string yaml_points(const std::vector<Vec2>& points, std::string_view indent) {
  std::string text = "[";
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) text += i % kPointsInALine == 0 ? fmt::format(",\n{}", indent) : ", ";
    text += point_text({points[i].x(), points[i].y()});
  }
  return text + "]";
}

std::string yaml_value(const ObjectField& field, std::string_view indent) {
  if (const auto* real = std::get_if<double*>(&field.target)) return rounded(**real / field.inner_unit);
  if (const auto* count = std::get_if<int*>(&field.target)) return fmt::format("{}", **count);
  if (const auto* whole = std::get_if<std::uint64_t*>(&field.target)) return fmt::format("{}", **whole);
  if (const auto* flag = std::get_if<bool*>(&field.target)) return **flag ? "true" : "false";
  if (const auto* point = std::get_if<PointTarget>(&field.target)) {
    std::vector<double> values;
    for (const double* value : point->coordinates) values.push_back(*value);
    return point_text(values);
  }
  if (const auto* points = std::get_if<std::vector<Vec2>*>(&field.target)) {
    return yaml_points(**points, indent);
  }
  if (const auto* text = std::get_if<std::string*>(&field.target)) return yaml_quoted(**text);
  const auto& word = std::get<WordTarget>(field.target);
  return std::string(word.words[word.index()]);
}

}  // namespace aisle
