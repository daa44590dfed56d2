#pragma once

#include <filesystem>

#include "aisle/commands/outcome.hpp"

namespace aisle {

/// What a recording holds that aisle did not make: the topics of a bag and what each could serve for, or the
/// scans and the odometry of a laser log.
Result<Outcome> recording_info(const std::filesystem::path& recording, Console& console);

}  // namespace aisle
