#pragma once

#include "aisle/core/parameters.hpp"
#include "aisle/geometry/camera_model.hpp"

namespace aisle {

/// What a camera of a vehicle or building file has besides its usual keys if its lens is not plumb_bob:
/// is_fisheye, k4, k5, k6.
class OtherLens {
 public:
  explicit OtherLens(CameraIntrinsics& lens)
      : lens_(&lens), is_fisheye_(lens.model == LensModel::kEquidistant) {}

  /// Whether a file needs the keys to tell of this lens.
  static bool is_needed(const CameraIntrinsics& lens) { return lens.model != LensModel::kPlumbBob; }

  /// The fields are valid as long as this object lives.
  void describe(FieldList& fields);

  /// The model, once the fields are read: equidistant if it is a fisheye, rational_polynomial if it has more
  /// than k3.
  void settle_model();

 private:
  CameraIntrinsics* lens_;
  bool is_fisheye_;
};

}  // namespace aisle
