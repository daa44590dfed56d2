#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "aisle/core/result.hpp"
#include "aisle/formats/connections/connection_file.hpp"
#include "aisle/wire/wire.hpp"

namespace aisle {

/// A topic of a network, and what it could serve for.
struct SurveyedTopic {
  std::string name;
  std::string type;
  std::size_t publishers = 0;
  std::size_t subscribers = 0;
  bool reliable = false;  ///< a publisher is
  bool latched = false;   ///< a publisher is
  std::string use;        ///< "scan", "odometry", "command", ...; empty: aisle has no use for it
};

/// The topics of others, sorted by name and type.
std::vector<SurveyedTopic> survey(const std::vector<WireEndpoint>& endpoints);

/// The connection that fits what a survey found. Each choice among several is a warning; what there is none
/// of is a problem.
Result<Connection> suggested_connection(const std::vector<SurveyedTopic>& topics, Connection connection,
                                        Problems& warnings);

}  // namespace aisle
