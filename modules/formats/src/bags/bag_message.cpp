#include "aisle/formats/bags/bag_message.hpp"

#include <array>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "aisle/formats/sessions/cdr.hpp"

namespace aisle {
namespace {

template <class Field>
concept HasFields = requires(Field& field) {
  Field::fields(field, [](const char*, auto&) {});
};

/// Reads the fields of a message of ROS 1.
class Ros1Fields {
 public:
  explicit Ros1Fields(std::string_view bytes) : rest_(bytes) {}

  template <class Field>
  void operator()(const char* /*name*/, Field& field) {
    read(field);
  }
  bool is_short() const { return is_short_; }

 private:
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void read(Number& field) { copy(&field, sizeof(Number)); }
  void read(bool& field) {
    std::uint8_t byte = 0;
    read(byte);
    field = byte != 0;
  }
  template <HasFields Field>
  void read(Field& field) {
    Field::fields(field, *this);
  }
  void read(ros::Header& header) {
    std::uint32_t sequence = 0;
    read(sequence);
    ros::Header::fields(header, *this);
  }
  void read(std::string& text) {
    text.resize(read_count(1));
    copy(text.data(), text.size());
  }
  template <class Number, std::size_t count>
  void read(std::array<Number, count>& numbers) {
    copy(numbers.data(), sizeof(numbers));
  }
  template <class Element>
  void read(std::vector<Element>& elements) {
    if constexpr (std::is_arithmetic_v<Element>) {
      elements.resize(read_count(sizeof(Element)));
      copy(elements.data(), elements.size() * sizeof(Element));
    } else {
      for (std::size_t left = read_count(sizeof(std::uint32_t)); left > 0 && !is_short_; --left)
        read(elements.emplace_back());
    }
  }

  /// Zero if so many elements do not fit into the bytes that are left.
  std::size_t read_count(std::size_t element_bytes) {
    std::uint32_t count = 0;
    read(count);
    if (count <= rest_.size() / element_bytes) return count;
    is_short_ = true;
    return 0;
  }
  void copy(void* to, std::size_t bytes) {
    if (bytes > rest_.size()) {
      is_short_ = true;
      rest_ = {};
    } else if (bytes > 0) {
      std::memcpy(to, rest_.data(), bytes);
      rest_.remove_prefix(bytes);
    }
  }

  std::string_view rest_;
  bool is_short_ = false;
};

}  // namespace

template <class Message>
std::optional<Message> parse_message(std::string_view bytes, BagEncoding encoding) {
  if (encoding == BagEncoding::kCdr) return parse_cdr<Message>(bytes);
  Ros1Fields fields(bytes);
  Message message;
  fields("", message);
  if (fields.is_short()) return std::nullopt;
  return message;
}

std::optional<ros::Header> parse_header(std::string_view bytes, BagEncoding encoding) {
  return parse_message<ros::Header>(bytes, encoding);
}

#define AISLE_BAG_MESSAGE(Message) \
  template std::optional<ros::Message> parse_message(std::string_view, BagEncoding);

AISLE_BAG_MESSAGE(String)
AISLE_BAG_MESSAGE(Bool)
AISLE_BAG_MESSAGE(Image)
AISLE_BAG_MESSAGE(CompressedImage)
AISLE_BAG_MESSAGE(CameraInfo)
AISLE_BAG_MESSAGE(LaserScan)
AISLE_BAG_MESSAGE(JointState)
AISLE_BAG_MESSAGE(Pose)
AISLE_BAG_MESSAGE(PoseStamped)
AISLE_BAG_MESSAGE(PoseWithCovarianceStamped)
AISLE_BAG_MESSAGE(TransformStamped)
AISLE_BAG_MESSAGE(Twist)
AISLE_BAG_MESSAGE(TwistStamped)
AISLE_BAG_MESSAGE(Odometry)
AISLE_BAG_MESSAGE(TFMessage)

#undef AISLE_BAG_MESSAGE

}  // namespace aisle
