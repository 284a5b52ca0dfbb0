#pragma once
/// What a marginal cannot be.

#include <sstream>
#include <stdexcept>

namespace uq {

/// @throws std::invalid_argument "normal: mean is nan; allowed: a finite number"
[[noreturn]] inline void refuse(const char* what, double value, const char* allowed)
{
    std::ostringstream text;
    text.precision(17);
    text << what << " is " << value << "; allowed: " << allowed;
    throw std::invalid_argument(text.str());
}

} // namespace uq
