#include "buildings/building_parts.hpp"
#include "other_lens.hpp"

namespace aisle {
namespace {

/// Enough to survive a change of unit, and more than any calibration is accurate to.
constexpr Digits kCameraDigits = {12, Digits::Kind::kSignificant};

void add_fields(JsonFields& fields, const FieldList& parameters, bool are_needed) {
  for (const Field& parameter : parameters.all()) {
    const FieldTarget target =
        std::visit([](auto* variable) { return FieldTarget(variable); }, parameter.target);
    fields.push_back(
        ObjectField{parameter.key, target, parameter.range, parameter.inner_unit, kCameraDigits, are_needed});
  }
}

/// A camera and its keys; a copy would name the variables of another one.
struct DescribedCamera {
  explicit DescribedCamera(CameraDescription& camera)
      : name(needed(field::text("name", camera.name))),
        usual(fields_of(camera)),
        lens(camera.intrinsics),
        of_lens(fields_of(lens)) {}
  DescribedCamera(const DescribedCamera&) = delete;
  DescribedCamera& operator=(const DescribedCamera&) = delete;

  JsonFields fields(bool with_lens) const {
    JsonFields all = {name};
    add_fields(all, usual, true);
    if (with_lens) add_fields(all, of_lens, false);
    return all;
  }

  ObjectField name;
  FieldList usual;
  OtherLens lens;
  FieldList of_lens;
};

std::string camera_json(CameraDescription& camera) {
  return object_json(DescribedCamera(camera).fields(OtherLens::is_needed(camera.intrinsics)));
}

void read_camera(const JsonValue& value, CameraDescription& camera) {
  DescribedCamera described(camera);
  read_object(value, described.fields(true));
  described.lens.settle_model();
}

}  // namespace

JsonPart camera_part(std::string_view key, std::optional<CameraDescription>& camera) {
  return {key, [&camera] { return camera ? camera_json(*camera) : std::string(); },
          [&camera](const JsonValue& value) { read_camera(value, camera.emplace()); }};
}

}  // namespace aisle
