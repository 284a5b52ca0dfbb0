#include "core/moments.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace core {
namespace {

/// A sum and what rounding took from it (Neumaier 1974).
class CompensatedSum {
  public:
    void add(double x)
    {
        const double total = sum_ + x;
        lost_ += std::abs(sum_) >= std::abs(x) ? (sum_ - total) + x : (x - total) + sum_;
        sum_ = total;
    }
    [[nodiscard]] double value() const { return sum_ + lost_; }

  private:
    double sum_ = 0.0, lost_ = 0.0;
};

} // namespace

Moments moments(std::span<const double> y)
{
    if (y.size() < 2)
        throw std::invalid_argument("at least 2 sound samples are needed, got " +
                                    std::to_string(y.size()));
    const auto n = static_cast<double>(y.size());
    CompensatedSum from_first; // differences from a value of the sample lose no digits
    for (const double x : y) from_first.add(x - y[0]);
    const double shift = from_first.value() / n;
    CompensatedSum first, second;
    for (const double x : y) {
        const double d = (x - y[0]) - shift;
        first.add(d);
        second.add(d * d);
    }
    const double squares = second.value() - first.value() * first.value() / n;
    return {y[0] + shift, std::sqrt(std::max(0.0, squares) / (n - 1.0))};
}

} // namespace core
