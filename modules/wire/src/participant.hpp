#pragma once

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/topic/Topic.hpp>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/wire/wire.hpp"
#include "endpoint_table.hpp"

namespace aisle {

/// Gives a topic back to the participant that it was taken from.
struct TopicRelease {
  void operator()(eprosima::fastdds::dds::Topic* topic) const;
};
using TopicUse = std::unique_ptr<eprosima::fastdds::dds::Topic, TopicRelease>;

/// The Fast DDS participant behind a wire. The wire and all that it made share it; the last one closes it.
class Participant {
 public:
  /// @param settings that check_settings() finds nothing wrong with
  static Result<std::shared_ptr<Participant>> open(const WireSettings& settings);
  Participant(const Participant&) = delete;
  Participant& operator=(const Participant&) = delete;
  ~Participant();

  /// The topic for one more reader or writer.
  /// @param topic, type  as ROS says them
  /// @return problems if they are no names, or this topic is in use here with another type
  Result<TopicUse> use_topic(const std::string& topic, const std::string& type);

  eprosima::fastdds::dds::Publisher& publisher() { return *publisher_; }
  eprosima::fastdds::dds::Subscriber& subscriber() { return *subscriber_; }
  std::vector<WireEndpoint> endpoints() const { return table_.endpoints(); }

 private:
  Participant() = default;

  /// Fast DDS is closed after its last participant, whatever order a program ends in.
  std::shared_ptr<eprosima::fastdds::dds::DomainParticipantFactory> factory_;
  EndpointTable table_;
  eprosima::fastdds::dds::DomainParticipant* participant_ = nullptr;
  eprosima::fastdds::dds::Publisher* publisher_ = nullptr;
  eprosima::fastdds::dds::Subscriber* subscriber_ = nullptr;
  std::mutex topics_mutex_;
};

}  // namespace aisle
