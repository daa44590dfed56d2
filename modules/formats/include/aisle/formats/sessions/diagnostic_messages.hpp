#pragma once
/// What a robot's own monitors show of its programs; see ros_messages.hpp.

#include <cstdint>
#include <string>
#include <vector>

#include "aisle/formats/sessions/ros_messages.hpp"

namespace aisle::ros {

struct KeyValue {
  std::string key;
  std::string value;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("key", self.key);
    visit("value", self.value);
  }
  friend bool operator==(const KeyValue&, const KeyValue&) = default;
};

struct DiagnosticStatus {
  static constexpr std::uint8_t kOk = 0, kWarning = 1, kError = 2;
  std::uint8_t level = kOk;
  std::string name;
  std::string message;
  std::string hardware_id;
  std::vector<KeyValue> values;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("level", self.level);
    visit("name", self.name);
    visit("message", self.message);
    visit("hardware_id", self.hardware_id);
    visit("values", self.values);
  }
  friend bool operator==(const DiagnosticStatus&, const DiagnosticStatus&) = default;
};

struct DiagnosticArray {
  static constexpr const char* kType = "diagnostic_msgs/msg/DiagnosticArray";
  Header header;
  std::vector<DiagnosticStatus> status;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("header", self.header);
    visit("status", self.status);
  }
  friend bool operator==(const DiagnosticArray&, const DiagnosticArray&) = default;
};

}  // namespace aisle::ros
