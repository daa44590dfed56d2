#include "aisle/formats/sessions/cdr.hpp"
#include "fuzz_input.hpp"

using namespace aisle;

namespace {

/// What is read is written as something that reads the same: once written, the bytes stay as they are.
template <class Message>
void read_and_write(std::string_view bytes) {
  const auto message = parse_cdr<Message>(bytes);
  if (!message) return;
  const std::string written = cdr_bytes(*message);
  const auto again = parse_cdr<Message>(written);
  require(again.has_value());
  require(cdr_bytes(*again) == written);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text = fuzz_text(bytes, size);
  read_and_write<ros::String>(text);
  read_and_write<ros::Bool>(text);
  read_and_write<ros::Image>(text);
  read_and_write<ros::CompressedImage>(text);
  read_and_write<ros::CameraInfo>(text);
  read_and_write<ros::LaserScan>(text);
  read_and_write<ros::JointState>(text);
  read_and_write<ros::PoseStamped>(text);
  read_and_write<ros::Twist>(text);
  read_and_write<ros::Odometry>(text);
  read_and_write<ros::TFMessage>(text);
  return 0;
}
