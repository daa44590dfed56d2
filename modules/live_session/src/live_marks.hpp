#pragma once

#include <optional>
#include <string>

#include "aisle/vehicle/observation.hpp"

namespace aisle {

/// Of the service mission/mark; nullopt: there is no such kind.
std::optional<Mark::Kind> mark_kind(const std::string& name);

/// "place desk", "stop"
std::string mark_text(const Mark& mark);

}  // namespace aisle
