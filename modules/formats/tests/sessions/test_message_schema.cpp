#include "aisle/formats/sessions/message_schema.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace aisle {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(MessageSchema, IsTheDefinitionWithAllThatItIsMadeOf) {
  EXPECT_EQ(message_schema("std_msgs/msg/String"), "string data\n");
  EXPECT_EQ(message_schema("geometry_msgs/msg/Twist"),
            "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n" + std::string(80, '=') +
                "\nMSG: geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n");
}

TEST(MessageSchema, DefinesWhatIsNestedOnceAndSizesOfArrays) {
  const std::string schema = message_schema("nav_msgs/msg/Odometry");
  EXPECT_THAT(schema, StartsWith("std_msgs/Header header\nstring child_frame_id\n"));
  EXPECT_THAT(schema, HasSubstr("float64[36] covariance\n"));
  EXPECT_THAT(schema, HasSubstr("MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"));
  const std::string vector = "MSG: geometry_msgs/Vector3\n";
  EXPECT_THAT(schema.substr(schema.find(vector) + vector.size()), Not(HasSubstr(vector)));
}

TEST(MessageSchema, DefinesTheElementsOfLists) {
  EXPECT_THAT(message_schema("tf2_msgs/msg/TFMessage"),
              StartsWith("geometry_msgs/TransformStamped[] transforms\n"));
  EXPECT_THAT(message_schema("tf2_msgs/msg/TFMessage"), HasSubstr("MSG: geometry_msgs/TransformStamped\n"));
  EXPECT_THAT(message_schema("sensor_msgs/msg/CompressedImage"), EndsWith("int32 sec\nuint32 nanosec\n"));
}

TEST(MessageSchema, OfAnUnknownTypeIsABrokenContract) {
  EXPECT_THROW(message_schema("std_msgs/msg/Float64"), std::invalid_argument);
}

}  // namespace
}  // namespace aisle
