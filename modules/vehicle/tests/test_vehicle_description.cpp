#include <gmock/gmock.h>

#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {
namespace {

using testing::IsEmpty;
using testing::Not;

TEST(VehicleDescription, IsSetByItsKeys) {
  VehicleDescription vehicle;
  FieldList fields = fields_of(vehicle);
  EXPECT_THAT(fields.assign("is_differential", "true", {}), IsEmpty());
  EXPECT_THAT(fields.assign("front_steered.wheelbase_m", "0.8", {}), IsEmpty());
  EXPECT_THAT(fields.assign("front_steered_noise.steering_bias_deg", "2", {}), IsEmpty());
  EXPECT_THAT(fields.assign("differential.steps_per_turn", "400", {}), IsEmpty());
  EXPECT_TRUE(vehicle.is_differential);
  EXPECT_DOUBLE_EQ(vehicle.front_steered.wheelbase_m, 0.8);
  EXPECT_DOUBLE_EQ(vehicle.front_steered_noise.steering_bias_rad, 2 * kDegree);
  EXPECT_EQ(vehicle.differential.steps_per_turn, 400);
}

TEST(VehicleDescription, RefusesAVehicleWithoutLengthAndKeepsItsDefaultsWithinTheirRanges) {
  VehicleDescription vehicle;
  FieldList fields = fields_of(vehicle);
  EXPECT_THAT(fields.assign("front_steered.wheelbase_m", "0", {}), Not(IsEmpty()));
  for (const Field& field : fields.all()) {
    EXPECT_THAT(fields.assign(field.key, field.value_text(), {}), IsEmpty()) << field.key;
  }
}

}  // namespace
}  // namespace aisle
