#include "methods.hpp"

#include <fmt/format.h>

namespace aisle {

Problems check_method(const std::string& method) {
  if (method == "landmarks") return {};
  return {{{"", 0, "--method"}, fmt::format("'{}' is unknown; there is: landmarks", method)}};
}

}  // namespace aisle
