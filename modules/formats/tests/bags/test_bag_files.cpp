#include "bags/bag_files.hpp"

#include <gmock/gmock.h>

#include "bag_writers.hpp"
#include "session_samples.hpp"

namespace aisle {
namespace {

TEST(BagFiles, MetadataThatIsNoYamlIsSaidAndTheFilesAreTaken) {
  const SessionPlace place;
  write_file(place / "bag/x_0.mcap", "");
  write_file(place / "bag/metadata.yaml", "rosbag2_bagfile_information: [");
  const auto bag = bag_files(place / "bag");
  ASSERT_TRUE(bag.ok());
  EXPECT_THAT(bag->paths, testing::ElementsAre(place / "bag/x_0.mcap"));
  EXPECT_THAT(to_string(bag->warnings), testing::HasSubstr("is not YAML"));
}

}  // namespace
}  // namespace aisle
