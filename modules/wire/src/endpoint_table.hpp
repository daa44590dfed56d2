#pragma once

#include <fastdds/rtps/common/Guid.h>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <map>
#include <mutex>
#include <vector>

#include "aisle/wire/wire.hpp"

namespace aisle {

/// What others publish and subscribe, as Fast DDS finds and loses it. Of a participant that leaves or falls
/// silent, Fast DDS reports every endpoint as removed.
class EndpointTable final : public eprosima::fastdds::dds::DomainParticipantListener {
 public:
  /// Sorted by topic, type, kind and participant.
  std::vector<WireEndpoint> endpoints() const;

 private:
  using DomainParticipant = eprosima::fastdds::dds::DomainParticipant;

  void on_publisher_discovery(DomainParticipant* own,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  void on_subscriber_discovery(DomainParticipant* own,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
  template <class ProxyData>
  void keep(const DomainParticipant& own, WireEndpoint::Kind kind, const ProxyData& data);
  void forget(const eprosima::fastrtps::rtps::GUID_t& guid);

  mutable std::mutex mutex_;
  std::map<eprosima::fastrtps::rtps::GUID_t, WireEndpoint> endpoints_;
};

}  // namespace aisle
