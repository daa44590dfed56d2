#pragma once

#include <memory>
#include <string>

#include "aisle/wire/wire.hpp"
#include "participant.hpp"

namespace aisle {

/// See Wire::advertise().
Result<std::unique_ptr<WirePublisher>> open_publisher(std::shared_ptr<Participant> participant,
                                                      const std::string& topic, const std::string& type,
                                                      WireQuality quality);

}  // namespace aisle
