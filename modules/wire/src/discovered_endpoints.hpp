#pragma once

#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "aisle/wire/wire.hpp"

namespace aisle {

/// Keeps what others publish and subscribe, as Fast DDS discovers and loses it.
class DiscoveredEndpoints final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  using Participant = eprosima::fastdds::dds::DomainParticipant;

  void on_participant_discovery(Participant* participant,
                                eprosima::fastrtps::rtps::ParticipantDiscoveryInfo&& info) override;
  void on_subscriber_discovery(Participant* participant,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
  void on_publisher_discovery(Participant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;

  std::vector<WireEndpoint> sorted() const;

 private:
  using Guid = eprosima::fastrtps::rtps::GUID_t;

  template <class Info>
  void note(const Participant& participant, WireEndpoint::Kind kind, const Info& info, bool is_gone);

  mutable std::mutex mutex_;
  std::map<Guid, WireEndpoint> endpoints_;
};

}  // namespace aisle
