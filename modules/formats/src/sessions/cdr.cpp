#include "aisle/formats/sessions/cdr.hpp"

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <fastcdr/exceptions/Exception.h>

#include <array>
#include <type_traits>

#include "aisle/formats/sessions/diagnostic_messages.hpp"

namespace aisle {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;

constexpr std::size_t kEncapsulation_bytes = 4;

template <class Field>
concept Structure = requires(Field& field) {
  Field::fields(field, [](const char*, auto&) {});
};

/// The maximum size of the fields in bytes, including alignment padding.
class Room {
 public:
  template <class Field>
  void operator()(const char* /*name*/, const Field& field) {
    add(field);
  }
  std::size_t bytes() const { return bytes_; }

 private:
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void add(Number /*field*/) { bytes_ += 2 * sizeof(Number); }
  template <Structure Field>
  void add(const Field& field) {
    Field::fields(field, *this);
  }
  void add(const std::string& text) {
    add(std::uint32_t{});
    bytes_ += text.size() + 1;
  }
  template <class Number, std::size_t count>
  void add(const std::array<Number, count>& /*numbers*/) {
    bytes_ += (count + 1) * sizeof(Number);
  }
  template <class Element>
  void add(const std::vector<Element>& elements) {
    add(std::uint32_t{});
    if constexpr (std::is_arithmetic_v<Element>) {
      bytes_ += (elements.size() + 1) * sizeof(Element);
    } else {
      for (const Element& element : elements) add(element);
    }
  }

  std::size_t bytes_ = 0;
};

class Writer {
 public:
  explicit Writer(Cdr& cdr) : cdr_(cdr) {}

  template <class Field>
  void operator()(const char* /*name*/, const Field& field) {
    write(field);
  }

 private:
  template <class Field>
  requires(!Structure<Field>) void write(const Field& field) { cdr_ << field; }
  template <Structure Field>
  void write(const Field& field) {
    Field::fields(field, *this);
  }
  template <Structure Element>
  void write(const std::vector<Element>& elements) {
    cdr_ << static_cast<std::uint32_t>(elements.size());
    for (const Element& element : elements) write(element);
  }

  Cdr& cdr_;
};

/// Thrown if fewer bytes are left than a length announces.
struct TooShort {};

class Reader {
 public:
  Reader(Cdr& cdr, std::size_t bytes) : cdr_(cdr), bytes_(bytes) {}

  template <class Field>
  void operator()(const char* /*name*/, Field& field) {
    read(field);
  }

 private:
  template <class Field>
  requires(!Structure<Field>) void read(Field& field) { cdr_ >> field; }
  template <Structure Field>
  void read(Field& field) {
    Field::fields(field, *this);
  }
  template <class Element>
  void read(std::vector<Element>& elements) {
    if constexpr (std::is_arithmetic_v<Element>) {
      elements.resize(read_count(sizeof(Element)));
      if (!elements.empty()) cdr_.deserializeArray(elements.data(), elements.size());
    } else {
      for (std::size_t left = read_count(sizeof(std::uint32_t)); left > 0; --left)
        read(elements.emplace_back());
    }
  }
  void read(bool& field) {
    std::uint8_t byte = 0;
    cdr_ >> byte;
    field = byte != 0;
  }

  /// @param element_bytes  minimum size of an element
  std::size_t read_count(std::size_t element_bytes) {
    std::uint32_t count = 0;
    cdr_ >> count;
    if (count > (bytes_ - cdr_.getSerializedDataLength()) / element_bytes) throw TooShort();
    return count;
  }

  Cdr& cdr_;
  std::size_t bytes_;
};

}  // namespace

template <class Message>
std::string cdr_bytes(const Message& message) {
  Room room;
  Message::fields(message, room);
  std::string bytes(kEncapsulation_bytes + room.bytes(), '\0');  // padding must be zero: Fast-CDR skips it
  FastBuffer buffer(bytes.data(), bytes.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  Message::fields(message, Writer(cdr));
  bytes.resize(cdr.getSerializedDataLength());
  return bytes;
}

template <class Message>
std::optional<Message> parse_cdr(std::string_view bytes) {
  FastBuffer buffer(const_cast<char*>(bytes.data()), bytes.size());  // NOLINT: only read
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  Message message;
  try {
    cdr.read_encapsulation();
    Message::fields(message, Reader(cdr, bytes.size()));
  } catch (const eprosima::fastcdr::exception::Exception&) {
    return std::nullopt;
  } catch (const TooShort&) {
    return std::nullopt;
  }
  return message;
}

#define AISLE_MESSAGE(Message)                         \
  template std::string cdr_bytes(const ros::Message&); \
  template std::optional<ros::Message> parse_cdr(std::string_view);

AISLE_MESSAGE(String)
AISLE_MESSAGE(Bool)
AISLE_MESSAGE(Image)
AISLE_MESSAGE(CompressedImage)
AISLE_MESSAGE(CameraInfo)
AISLE_MESSAGE(LaserScan)
AISLE_MESSAGE(JointState)
AISLE_MESSAGE(Header)
AISLE_MESSAGE(Pose)
AISLE_MESSAGE(PoseStamped)
AISLE_MESSAGE(TransformStamped)
AISLE_MESSAGE(Twist)
AISLE_MESSAGE(TwistStamped)
AISLE_MESSAGE(AckermannDriveStamped)
AISLE_MESSAGE(Joy)
AISLE_MESSAGE(BatteryState)
AISLE_MESSAGE(Clock)
AISLE_MESSAGE(DiagnosticArray)
AISLE_MESSAGE(Odometry)
AISLE_MESSAGE(TFMessage)
AISLE_MESSAGE(PoseWithCovarianceStamped)
AISLE_MESSAGE(Path)
AISLE_MESSAGE(OccupancyGrid)
AISLE_MESSAGE(Marker)
AISLE_MESSAGE(MarkerArray)

#undef AISLE_MESSAGE

}  // namespace aisle
