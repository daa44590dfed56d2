#pragma once

#include <span>
#include <vector>

#include "aisle/vision/check/view_check.hpp"

namespace aisle {

/// What would probably help, in the order of ViewHint. @param check  complete but for its hints
std::vector<ViewHint> view_hints(const ViewCheck& check, std::span<const ImageEvidence> images,
                                 bool is_lens_known, const ViewCheckParams& params);

}  // namespace aisle
