#include "buildings/building_parts.hpp"

namespace aisle {
namespace {

/// Enough to survive a change of unit, and more than any calibration is accurate to.
constexpr Digits kCameraDigits = {12, Digits::Kind::kSignificant};

/// @param parameters  of the same camera
JsonFields camera_fields(CameraDescription& camera, const FieldList& parameters) {
  JsonFields fields = {needed(field::text("name", camera.name))};
  for (const Field& parameter : parameters.all()) {
    const FieldTarget target =
        std::visit([](auto* variable) { return FieldTarget(variable); }, parameter.target);
    fields.push_back(
        ObjectField{parameter.key, target, parameter.range, parameter.inner_unit, kCameraDigits, true});
  }
  return fields;
}

}  // namespace

JsonPart camera_part(std::string_view key, std::optional<CameraDescription>& camera) {
  return {
      key,
      [&camera] { return camera ? object_json(camera_fields(*camera, fields_of(*camera))) : std::string(); },
      [&camera](const JsonValue& value) {
        camera.emplace();
        const FieldList parameters = fields_of(*camera);
        read_object(value, camera_fields(*camera, parameters));
      }};
}

}  // namespace aisle
