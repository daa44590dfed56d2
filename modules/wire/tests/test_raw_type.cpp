#include <gtest/gtest.h>

#include "raw_type.hpp"

namespace aisle {
namespace {

struct Bytes : RawType::Payload {
  explicit Bytes(std::string& bytes, std::uint32_t claimed) {
    data = reinterpret_cast<unsigned char*>(bytes.data());
    max_size = static_cast<std::uint32_t>(bytes.size());
    length = claimed;
  }
  ~Bytes() { data = nullptr; }
};

TEST(RawType, GivesTheBytesAsTheyCame) {
  RawType type("a::msg::dds_::B_");
  std::string sent("\x00\x01\x00\x00\x07\x00", 6), room(6, ' '), received;
  Bytes payload(room, 0);
  std::string_view message = sent;
  EXPECT_EQ(type.getSerializedSizeProvider(&message)(), 6U);
  ASSERT_TRUE(type.serialize(&message, &payload));
  ASSERT_TRUE(type.deserialize(&payload, &received));
  EXPECT_EQ(received, sent);
}

TEST(RawType, RefusesWhatHasNoEncapsulationOrIsTooLarge) {
  RawType type("a::msg::dds_::B_");
  std::string bytes(4, '\0'), received;
  // The length is judged before the bytes are looked at.
  for (const std::uint32_t claimed : {0U, 3U, (64U << 20U) + 1, ~0U}) {
    Bytes payload(bytes, claimed);
    EXPECT_FALSE(type.deserialize(&payload, &received)) << claimed;
  }
  Bytes payload(bytes, 4);
  EXPECT_TRUE(type.deserialize(&payload, &received));
}

TEST(RawType, WritesNothingBeyondTheRoomThatIsThere) {
  RawType type("a::msg::dds_::B_");
  std::string room(4, ' ');
  Bytes payload(room, 0);
  std::string_view message = "12345";
  EXPECT_FALSE(type.serialize(&message, &payload));
}

}  // namespace
}  // namespace aisle
