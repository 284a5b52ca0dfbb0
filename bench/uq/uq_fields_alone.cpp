#include "bench/uq/uq_fields.hpp"

namespace bench {

/// OpenTURNS is not installed.
OtherTimes other_times(int) { return {}; }

} // namespace bench
