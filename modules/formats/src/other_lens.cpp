#include "other_lens.hpp"

namespace aisle {

void OtherLens::describe(FieldList& fields) {
  constexpr Range kCoefficient = {-1e4, 1e4};
  fields.flag("is_fisheye", is_fisheye_, "an equidistant lens (Kannala-Brandt), k1 to k4 by the angle");
  fields.real("k4", lens_->k4, kCoefficient, "of a fisheye, or below the line of rational_polynomial");
  fields.real("k5", lens_->k5, kCoefficient, "below the line of rational_polynomial");
  fields.real("k6", lens_->k6, kCoefficient, "below the line of rational_polynomial");
}

void OtherLens::settle_model() {
  const bool has_denominator = lens_->k4 != 0 || lens_->k5 != 0 || lens_->k6 != 0;
  lens_->model = is_fisheye_       ? LensModel::kEquidistant
                 : has_denominator ? LensModel::kRationalPolynomial
                                   : LensModel::kPlumbBob;
}

}  // namespace aisle
