#include "endpoint_table.hpp"

#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>

#include <algorithm>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <sstream>
#include <tuple>

#include "ros_names.hpp"

namespace aisle {
namespace {

namespace rtps = eprosima::fastrtps::rtps;

std::string text_of(const rtps::GuidPrefix_t& participant) {
  std::ostringstream text;
  text << participant;
  return text.str();
}

}  // namespace

std::vector<WireEndpoint> EndpointTable::endpoints() const {
  std::vector<WireEndpoint> sorted;
  {
    const std::lock_guard lock(mutex_);
    for (const auto& [guid, endpoint] : endpoints_) sorted.push_back(endpoint);
  }
  const auto rank = [](const WireEndpoint& e) { return std::tie(e.topic, e.type, e.kind, e.participant); };
  std::sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  return sorted;
}

void EndpointTable::on_publisher_discovery(DomainParticipant* own, rtps::WriterDiscoveryInfo&& info) {
  if (info.status == rtps::WriterDiscoveryInfo::REMOVED_WRITER)
    forget(info.info.guid());
  else
    keep(*own, WireEndpoint::Kind::kPublisher, info.info);
}

void EndpointTable::on_subscriber_discovery(DomainParticipant* own, rtps::ReaderDiscoveryInfo&& info) {
  if (info.status == rtps::ReaderDiscoveryInfo::REMOVED_READER)
    forget(info.info.guid());
  else
    keep(*own, WireEndpoint::Kind::kSubscriber, info.info);
}

template <class ProxyData>
void EndpointTable::keep(const DomainParticipant& own, WireEndpoint::Kind kind, const ProxyData& data) {
  const auto topic = ros_topic(data.topicName().to_string());
  if (!topic || data.guid().guidPrefix == own.guid().guidPrefix) return;
  WireEndpoint endpoint{.kind = kind, .topic = *topic, .type = ros_type(data.typeName().to_string())};
  endpoint.reliable = data.m_qos.m_reliability.kind == eprosima::fastdds::dds::RELIABLE_RELIABILITY_QOS;
  endpoint.latched = data.m_qos.m_durability.kind >= eprosima::fastdds::dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  endpoint.participant = text_of(data.guid().guidPrefix);
  const std::lock_guard lock(mutex_);
  endpoints_.insert_or_assign(data.guid(), std::move(endpoint));
}

void EndpointTable::forget(const rtps::GUID_t& guid) {
  const std::lock_guard lock(mutex_);
  endpoints_.erase(guid);
}

}  // namespace aisle
