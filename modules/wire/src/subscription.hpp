#pragma once

#include <memory>
#include <string>

#include "aisle/wire/wire.hpp"
#include "participant.hpp"

namespace aisle {

/// See Wire::subscribe().
Result<std::unique_ptr<WireSubscription>> open_subscription(std::shared_ptr<Participant> participant,
                                                            const std::string& topic, const std::string& type,
                                                            WireQuality quality, Wire::Sink sink);

}  // namespace aisle
