#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string_view>

#include "aisle/formats/sessions/cdr.hpp"
#include "aisle/formats/sessions/session_reader.hpp"
#include "session_samples.hpp"

namespace aisle {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string base64(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// Messages in the form that dump.mjs prints.
struct ToJson {
  static json of(bool value) { return value; }
  static json of(const std::string& value) { return value; }
  static json of(const ros::Time& value) { return {{"sec", value.sec}, {"nsec", value.nanosec}}; }
  static json of(const std::vector<std::uint8_t>& bytes) { return {{"base64", base64(bytes)}}; }

  template <class Number>
  requires std::is_arithmetic_v<Number>
  static json of(Number value) {
    const auto number = static_cast<double>(value);
    if (!std::isfinite(number)) return nullptr;
    if (number == 0 && std::signbit(number)) return {{"negative_zero", true}};
    return value;
  }
  template <class Element>
  static json of(const std::vector<Element>& elements) {
    return list(elements);
  }
  template <class Element, std::size_t count>
  static json of(const std::array<Element, count>& elements) {
    return list(elements);
  }
  template <class Message>
  requires requires(Message& message) {
    Message::fields(message, [](const char*, auto&) {});
  }
  static json of(const Message& message) {
    json fields = json::object();
    Message::fields(message, [&](const char* name, const auto& field) { fields[name] = of(field); });
    return fields;
  }

 private:
  template <class Elements>
  static json list(const Elements& elements) {
    json values = json::array();
    for (const auto& element : elements) values.push_back(of(element));
    return values;
  }
};

template <class... Messages>
json decoded(const SessionReader::Message& message) {
  json result;
  const auto try_as = [&]<class Candidate>(std::type_identity<Candidate>) {
    if (message.topic.type == Candidate::kType)
      result = ToJson::of(parse_cdr<Candidate>(message.cdr).value());
  };
  (try_as(std::type_identity<Messages>()), ...);
  return result;
}

json decoded_by_us(const SessionReader::Message& message) {
  return decoded<ros::String, ros::Bool, ros::Image, ros::CompressedImage, ros::CameraInfo, ros::LaserScan,
                 ros::JointState, ros::PoseStamped, ros::Twist, ros::Odometry, ros::TFMessage>(message);
}

/// The output of the independent reader, one message per line.
std::vector<json> decoded_by_them(const fs::path& database) {
  const std::string command = "node " AISLE_READER "/dump.mjs '" + database.string() + "'";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> output(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 1 << 16> chunk{};
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), output.get()))
    text.append(chunk.data(), count);
  std::vector<json> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    lines.push_back(json::parse(text.substr(start, end - start)));
    start = end + 1;
  }
  return lines;
}

void expect_same_messages(const fs::path& directory) {
  auto reader = SessionReader::open(directory);
  ASSERT_TRUE(reader.ok()) << to_string(reader.problems());
  const std::vector<json> theirs = decoded_by_them(reader->database());
  ASSERT_GT(theirs.size(), 100U);
  for (const json& their : theirs) {
    const auto message = reader->next();
    ASSERT_TRUE(message.ok() && message->has_value());
    const SessionReader::Message& our = **message;
    EXPECT_EQ(their.at("topic"), our.topic.name);
    EXPECT_EQ(their.at("type"), our.topic.type);
    EXPECT_EQ(their.at("stamp"), ToJson::of(ros::time_of(our.stamp)));
    EXPECT_EQ(their.at("message"), decoded_by_us(our)) << our.topic.name;
  }
  EXPECT_FALSE(reader->next()->has_value());
}

TEST(IndependentReader, DecodesEveryMessageAsWeDo) {
  const SessionPlace place;
  for (const auto kind : {ImageCoding::Kind::kRaw, ImageCoding::Kind::kJpeg, ImageCoding::Kind::kPng}) {
    const fs::path directory = place / ("drive" + std::to_string(static_cast<int>(kind)));
    record_sample(directory, 20, {kind});
    expect_same_messages(directory);
  }
}

}  // namespace
}  // namespace aisle
