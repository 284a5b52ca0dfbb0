#include "bench/validation/cells.hpp"

#include "app/input/number_text.hpp"
#include "app/study/fragility_text.hpp"
#include "fragility/binomial.hpp"

namespace bench {
namespace {

constexpr double kZ = 1.959963984540054; // 95 %

} // namespace

std::string with_interval(const Sample& s, int decimals)
{
    if (s.n == 0) return "none";
    if (s.n == 1) return app::fixed(s.mean, decimals) + " (1 wall)";
    const double h = kZ * s.std_error();
    return app::with_interval(s.mean, s.mean - h, s.mean + h, decimals);
}

std::string share_cell(std::size_t k, std::size_t n)
{
    const auto i = fragility::binomial_interval(fragility::BinomialInterval::wilson,
                                                static_cast<double>(k), static_cast<double>(n));
    return app::with_interval(100.0 * static_cast<double>(k) / static_cast<double>(n),
                              100.0 * i.lower, 100.0 * i.upper, 0);
}

} // namespace bench
