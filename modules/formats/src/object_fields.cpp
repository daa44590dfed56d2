#include "object_fields.hpp"

#include "aisle/core/angle.hpp"

namespace aisle {
namespace field {

ObjectField number(std::string_view key, double& target, Range range, Digits digits) {
  return {.key = key, .target = &target, .range = range, .digits = digits};
}

ObjectField angle(std::string_view key, double& target_rad, Range range_deg, Digits digits) {
  return {.key = key, .target = &target_rad, .range = range_deg, .inner_unit = kDegree, .digits = digits};
}

ObjectField count(std::string_view key, int& target, Range range) {
  return {.key = key, .target = &target, .range = range};
}

ObjectField whole_number(std::string_view key, std::uint64_t& target) {
  return {.key = key, .target = &target};
}

ObjectField flag(std::string_view key, bool& target) {
  return {.key = key, .target = &target};
}

ObjectField text(std::string_view key, std::string& target) {
  return {.key = key, .target = &target};
}

ObjectField point(std::string_view key, double& x_m, double& y_m, Range range, Digits digits) {
  return {.key = key, .target = PointTarget{{&x_m, &y_m}}, .range = range, .digits = digits};
}

ObjectField point(std::string_view key, Vec2& target, Range range, Digits digits) {
  return point(key, target.x(), target.y(), range, digits);
}

ObjectField point(std::string_view key, Vec3& target, Range range) {
  return {.key = key, .target = PointTarget{{&target.x(), &target.y(), &target.z()}}, .range = range};
}

ObjectField points(std::string_view key, std::vector<Vec2>& target, Range range) {
  return {.key = key, .target = &target, .range = range};
}

}  // namespace field

ObjectField needed(ObjectField field) {
  field.is_needed = true;
  return field;
}

}  // namespace aisle
