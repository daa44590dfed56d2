#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

void VehicleDescription::describe(FieldList& fields) {
  fields.flag("is_differential", is_differential,
              "two wheels with a motor each, instead of steered front wheels");
  fields.group("front_steered", front_steered);
  fields.group("front_steered_noise", front_steered_noise);
  fields.group("differential", differential);
  fields.group("differential_noise", differential_noise);
}

}  // namespace aisle
