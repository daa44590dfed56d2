#include "buildings/camera_json.hpp"

#include <fmt/format.h>

#include "buildings/json_text.hpp"

namespace aisle {
namespace {

/// Twelve digits: enough to survive a change of unit, more than any calibration is accurate to.
std::string field_json(const Field& field) {
  if (const auto* real = std::get_if<double*>(&field.target))
    return fmt::format("\"{}\": {:.12g}", field.key, **real / field.inner_unit);
  return fmt::format("\"{}\": {}", field.key, field.value_text());
}

void read_field(const JsonValue& value, const Field& field) {
  if (auto* const* real = std::get_if<double*>(&field.target)) {
    double in_unit = 0;
    value.read_number(in_unit, field.range.min, field.range.max);
    **real = in_unit * field.inner_unit;
  } else if (auto* const* count = std::get_if<int*>(&field.target)) {
    value.read_count(**count, static_cast<int>(field.range.min), static_cast<int>(field.range.max));
  } else {
    value.read(*std::get<bool*>(field.target));
  }
}

}  // namespace

std::string camera_json(const CameraDescription& camera) {
  CameraDescription copy = camera;
  const FieldList fields = fields_of(copy);
  std::string text = "{\"name\": " + quoted_json(camera.name);
  for (const Field& field : fields.all()) text += ", " + field_json(field);
  return text + "}";
}

CameraDescription read_camera(const JsonValue& value) {
  CameraDescription camera;
  const FieldList fields = fields_of(camera);
  std::vector<std::string_view> known = {"name"};
  for (const Field& field : fields.all()) known.emplace_back(field.key);
  if (!value.is_object_of(known)) return camera;
  if (const auto name = value.require("name")) name->read_name(camera.name);
  for (const Field& field : fields.all()) {
    if (const auto member = value.require(field.key.c_str())) read_field(*member, field);
  }
  return camera;
}

}  // namespace aisle
