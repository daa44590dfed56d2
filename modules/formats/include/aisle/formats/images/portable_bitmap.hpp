#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "aisle/core/result.hpp"

namespace aisle {

/// A black and white image (PBM); row 0 is the top.
struct PortableBitmap {
  int width = 0;
  int height = 0;
  std::vector<bool> black;  ///< row by row; a 1 in the PBM file

  bool is_black(int column, int row) const {
    return black[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(column)];
  }
};

/// PBM, plain (P1) or raw (P4). More than `max_size` columns or rows, or fewer pixels than announced, is a
/// problem.
Result<PortableBitmap> parse_pbm(std::string_view bytes, const std::string& name, int max_size);

}  // namespace aisle
