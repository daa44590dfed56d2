#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>
#include <set>
#include <string>

#include "aisle/wire/wire.hpp"

namespace aisle {

eprosima::fastdds::dds::DataReaderQos reader_qos(WireQuality quality);
eprosima::fastdds::dds::DataWriterQos writer_qos(WireQuality quality);

/// What a subscription asks for and a publisher does not offer: "reliability", "durability".
std::set<std::string> missing_quality(WireQuality asked, const WireEndpoint& offered);

}  // namespace aisle
