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

/// What a mission sensed in one cycle, and what it decided.
struct SessionCycle {
  Observation observation;
  std::optional<Decision> decision;  ///< absent if the recording ended between the two
};

/// A session as written by SessionRecord, cycle by cycle. Messages on /truth are never read.
class SessionCycles {
 public:
  /// A bag without the topics of a cycle is a problem that names them.
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
