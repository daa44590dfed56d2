#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "aisle/core/result.hpp"
#include "aisle/formats/sessions/session_origin.hpp"
#include "aisle/guidance/navigator.hpp"
#include "aisle/vehicle/observation.hpp"
#include "aisle/vehicle/vehicle_description.hpp"

namespace aisle {

/// What a mission saw in one cycle, and what was decided on it.
struct SessionCycle {
  Observation observation;
  std::optional<Decision> decision;  ///< absent where the recording ended between the two
};

/// A session as SessionRecord keeps it, cycle by cycle. Messages on /truth are never looked at.
class SessionCycles {
 public:
  /// A bag without the topics that a cycle is made of is a problem that names them.
  static Result<SessionCycles> open(const std::filesystem::path& directory);

  SessionCycles(SessionCycles&&) noexcept;
  SessionCycles& operator=(SessionCycles&&) noexcept;
  ~SessionCycles();

  const VehicleDescription& vehicle() const;
  const SessionOrigin& origin() const;

  /// @return nullopt after the last
  Result<std::optional<SessionCycle>> next();

 private:
  class Source;

  explicit SessionCycles(std::unique_ptr<Source> source);

  std::unique_ptr<Source> source_;
};

}  // namespace aisle
