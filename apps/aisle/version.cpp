#include "version.hpp"

std::string release() {
  return AISLE_RELEASE;
}

std::string version() {
  const std::string commit = AISLE_COMMIT;
  return release() + " (commit " + (commit.empty() ? "unknown" : commit) + ", " + AISLE_BUILD_TYPE + ", " +
         AISLE_INSTRUCTION_SET + ")";
}
