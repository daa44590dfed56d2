#include <gmock/gmock.h>

#include "aisle/mqtt/mqtt_client.hpp"

namespace aisle {
namespace {

std::string why_not_connected(const std::string& url) {
  const auto client = MqttClient::connect({.url = url, .client_id = "test", .connect_s = 2});
  return client ? "" : to_string(client.problems());
}

TEST(MqttClient, UrlsThatAreNoneAreRefused) {
  for (const char* url : {"", "localhost", "http://localhost", "mqtt://", "mqtt:///", "mqtts://a/b"})
    EXPECT_THAT(why_not_connected(url), testing::HasSubstr("is neither mqtt://")) << url;
}

TEST(MqttClient, ABrokerThatIsNotThereIsAProblem) {
  EXPECT_THAT(why_not_connected("mqtt://127.0.0.1:1"), testing::HasSubstr("cannot be connected to"));
}

}  // namespace
}  // namespace aisle
