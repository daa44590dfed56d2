#pragma once

namespace aisle {

/// What the file of a session is; what it holds is the same.
enum class SessionStorage {
  kSqlite,  ///< NAME_0.db3
  kMcap,    ///< NAME_0.mcap
};

}  // namespace aisle
