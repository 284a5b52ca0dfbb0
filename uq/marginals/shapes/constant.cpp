#include "uq/marginals/shapes/constant.hpp"

#include "uq/marginals/shapes/shape_checks.hpp"

namespace uq {

void check(const Constant& s) { require_finite("constant: value", s.value); }

} // namespace uq
