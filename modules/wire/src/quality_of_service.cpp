#include "quality_of_service.hpp"

namespace aisle {
namespace {

namespace fdds = eprosima::fastdds::dds;

bool is_reliable(WireQuality quality) {
  return quality != WireQuality::kSensor;
}

bool is_latched(WireQuality quality) {
  return quality == WireQuality::kLatched;
}

int history_depth(WireQuality quality) {
  switch (quality) {
    case WireQuality::kSensor:
      return 5;
    case WireQuality::kCommand:
      return 1;
    case WireQuality::kDefault:
    case WireQuality::kLatched:
      break;
  }
  return 10;
}

template <class EndpointQos>
EndpointQos endpoint_qos(WireQuality quality) {
  EndpointQos qos;
  qos.reliability().kind =
      is_reliable(quality) ? fdds::RELIABLE_RELIABILITY_QOS : fdds::BEST_EFFORT_RELIABILITY_QOS;
  qos.reliability().max_blocking_time = {0, 100'000'000};
  // Said in any case: a writer of Fast DDS is latched by default.
  qos.durability().kind =
      is_latched(quality) ? fdds::TRANSIENT_LOCAL_DURABILITY_QOS : fdds::VOLATILE_DURABILITY_QOS;
  qos.history().kind = fdds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = history_depth(quality);
  qos.endpoint().history_memory_policy = eprosima::fastrtps::rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
  // Shared memory would outlive a killed program.
  qos.data_sharing().off();
  return qos;
}

}  // namespace

fdds::DataReaderQos reader_qos(WireQuality quality) {
  return endpoint_qos<fdds::DataReaderQos>(quality);
}

fdds::DataWriterQos writer_qos(WireQuality quality) {
  auto qos = endpoint_qos<fdds::DataWriterQos>(quality);
  qos.publish_mode().kind = fdds::SYNCHRONOUS_PUBLISH_MODE;
  // What was lost is missed at the next heartbeat: a last command must not take the three seconds of the
  // default.
  qos.reliable_writer_qos().times.heartbeatPeriod = {0, 100'000'000};
  return qos;
}

std::set<std::string> missing_quality(WireQuality asked, const WireEndpoint& offered) {
  std::set<std::string> missing;
  if (is_reliable(asked) && !offered.reliable) missing.emplace("reliability");
  if (is_latched(asked) && !offered.latched) missing.emplace("durability");
  return missing;
}

}  // namespace aisle
