#include "bench/validation/cells.hpp"

#include "app/output/table/cells.hpp"
#include "core/binomial.hpp"

namespace bench {

app::Cell with_interval(const Sample& s, int decimals)
{
    if (s.n == 0) return {};
    if (s.n == 1) return app::plain_number(s.mean, decimals);
    const double h = kZ * s.std_error();
    return app::with_interval(s.mean, s.mean - h, s.mean + h, decimals);
}

app::Cell share_cell(std::size_t k, std::size_t n)
{
    const auto i = core::binomial_interval(core::BinomialInterval::wilson,
                                           static_cast<double>(k), static_cast<double>(n));
    return app::with_interval(100.0 * static_cast<double>(k) / static_cast<double>(n),
                              100.0 * i.lower, 100.0 * i.upper, 0);
}

} // namespace bench
