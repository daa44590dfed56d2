#include "discovered_endpoints.hpp"

#include <fastdds/rtps/participant/ParticipantDiscoveryInfo.h>
#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>
#include <algorithm>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <sstream>
#include <tuple>

#include "ros_names.hpp"

namespace aisle {
namespace {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

std::string participant_name(const rtps::GuidPrefix_t& prefix) {
  std::ostringstream text;
  text << prefix;
  return text.str();
}

auto order(const WireEndpoint& endpoint) {
  return std::tie(endpoint.topic, endpoint.type, endpoint.kind, endpoint.participant);
}

}  // namespace

void DiscoveredEndpoints::on_participant_discovery(Participant* /*participant*/,
                                                   rtps::ParticipantDiscoveryInfo&& info) {
  using Info = rtps::ParticipantDiscoveryInfo;
  if (info.status != Info::REMOVED_PARTICIPANT && info.status != Info::DROPPED_PARTICIPANT) return;
  const rtps::GuidPrefix_t gone = info.info.m_guid.guidPrefix;
  const std::lock_guard lock(mutex_);
  std::erase_if(endpoints_, [&](const auto& entry) { return entry.first.guidPrefix == gone; });
}

void DiscoveredEndpoints::on_subscriber_discovery(Participant* participant,
                                                  rtps::ReaderDiscoveryInfo&& info) {
  note(*participant, WireEndpoint::Kind::kSubscriber, info.info,
       info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER);
}

void DiscoveredEndpoints::on_publisher_discovery(Participant* participant, rtps::WriterDiscoveryInfo&& info) {
  note(*participant, WireEndpoint::Kind::kPublisher, info.info,
       info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER);
}

template <class Info>
void DiscoveredEndpoints::note(const Participant& participant, WireEndpoint::Kind kind, const Info& info,
                               bool is_gone) {
  const Guid guid = info.guid();
  if (guid.guidPrefix == participant.guid().guidPrefix) return;
  const auto topic = ros_topic(info.topicName().to_string());
  if (!topic) return;
  const std::lock_guard lock(mutex_);
  if (is_gone) {
    endpoints_.erase(guid);
    return;
  }
  endpoints_[guid] = {kind,
                      *topic,
                      ros_type(info.typeName().to_string()),
                      info.m_qos.m_reliability.kind == dds::RELIABLE_RELIABILITY_QOS,
                      info.m_qos.m_durability.kind != dds::VOLATILE_DURABILITY_QOS,
                      participant_name(guid.guidPrefix)};
}

std::vector<WireEndpoint> DiscoveredEndpoints::sorted() const {
  std::vector<WireEndpoint> endpoints;
  {
    const std::lock_guard lock(mutex_);
    endpoints.reserve(endpoints_.size());
    for (const auto& [guid, endpoint] : endpoints_) endpoints.push_back(endpoint);
  }
  std::sort(endpoints.begin(), endpoints.end(),
            [](const WireEndpoint& a, const WireEndpoint& b) { return order(a) < order(b); });
  return endpoints;
}

}  // namespace aisle
