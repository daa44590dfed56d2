#include "image_sequences/left_out.hpp"

#include <fmt/format.h>

namespace aisle {

void LeftOut::warn(const std::string& kind, Problems& warnings) const {
  if (count_ == 0) return;
  warnings.push_back({first_.where, count_ == 1 ? fmt::format("{}; 1 {} is left out", first_.what, kind)
                                                : fmt::format("{}; {} {}s are left out, this is the first",
                                                              first_.what, count_, kind)});
}

}  // namespace aisle
