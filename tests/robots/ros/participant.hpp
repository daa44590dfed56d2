#pragma once

#include <dds/dds.h>

#include <optional>
#include <string>

#include "cdr.hpp"

namespace robots {

/// The profiles of ROS 2.
enum class Quality {
  kSensor,   ///< best effort, volatile, the last 5
  kDefault,  ///< reliable, volatile, the last 10
  kLatched,  ///< reliable, transient local, the last 1
};

/// Part of a ROS 2 network on this machine alone: Cyclone DDS on 127.0.0.1, others found without multicast.
/// Whatever cannot be created throws std::runtime_error.
class Participant {
 public:
  /// @param domain ROS_DOMAIN_ID, 0 to 101
  /// @param lease_s  others miss it so long after it has ended
  explicit Participant(unsigned domain, unsigned lease_s = 10);
  ~Participant();
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;

  /// @param topic, type as ROS says them: "/scan", "sensor_msgs/msg/LaserScan"
  dds_entity_t writer(const std::string& topic, const std::string& type, Quality quality) const;
  dds_entity_t reader(const std::string& topic, const std::string& type, Quality quality) const;

 private:
  dds_entity_t entity_;
};

void write_bytes(dds_entity_t writer, const std::string& message);
std::optional<std::string> take_bytes(dds_entity_t reader);
/// Waits until there is something to take. @return whether there is
bool wait_for_bytes(dds_entity_t reader, double timeout_s);
std::size_t matched_readers(dds_entity_t writer);

template <CdrMessage Message>
class Publisher {
 public:
  Publisher(const Participant& participant, const std::string& topic, Quality quality)
      : writer_(participant.writer(topic, Message::kType, quality)) {}

  void publish(const Message& message) const { write_bytes(writer_, to_cdr(message)); }
  std::size_t subscribers() const { return matched_readers(writer_); }

 private:
  dds_entity_t writer_;
};

/// Messages are taken when the program wants them; none arrives in between.
template <CdrMessage Message>
class Subscription {
 public:
  Subscription(const Participant& participant, const std::string& topic, Quality quality)
      : reader_(participant.reader(topic, Message::kType, quality)) {}

  /// The oldest message that has not been taken; what cannot be read is left out.
  std::optional<Message> take() const {
    while (const auto bytes = take_bytes(reader_)) {
      if (auto message = from_cdr<Message>(*bytes)) return message;
    }
    return std::nullopt;
  }

  /// As take(), but waits for a message.
  std::optional<Message> wait(double timeout_s) const {
    while (wait_for_bytes(reader_, timeout_s)) {
      if (auto message = take()) return message;
    }
    return std::nullopt;
  }

 private:
  dds_entity_t reader_;
};

}  // namespace robots
