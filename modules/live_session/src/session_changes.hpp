#pragma once
/// The services that change recorded sessions: docs/reference/live-server.md. Call them while nothing is
/// recorded or replayed.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "aisle/core/problem.hpp"

namespace aisle {

/// Gives a session of the folder another name: {"session": ..., "to": ...}. None is replaced.
Problems rename_session(const std::filesystem::path& sessions, const nlohmann::json& arguments);

/// Deletes a session for good: {"session": ...}. Refused where its folder holds other folders, which are no
/// part of a session.
Problems delete_session(const std::filesystem::path& sessions, const nlohmann::json& arguments);

}  // namespace aisle
