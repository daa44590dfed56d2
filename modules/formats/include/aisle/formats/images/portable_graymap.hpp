#pragma once

#include <string>
#include <string_view>

#include "aisle/core/image.hpp"
#include "aisle/core/result.hpp"

namespace aisle {

/// PGM, plain (P2) or raw (P5), as a grey image scaled so that the file's maximum value becomes 255. More
/// than `max_size` columns or rows, fewer pixels than announced, or a pixel above the maximum value is a
/// problem.
Result<Image> parse_pgm(std::string_view bytes, const std::string& name, int max_size);

}  // namespace aisle
