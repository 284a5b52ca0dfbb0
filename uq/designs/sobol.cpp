#include "uq/designs/sobol.hpp"

#include "uq/designs/stream.hpp"

#include <boost/random/detail/sobol_table.hpp>

#include <array>
#include <bit>
#include <stdexcept>
#include <string>

namespace uq {
namespace {

constexpr int kDigits = 52; // of a coordinate
constexpr int kIndexBits = 32;
using Directions = std::array<std::uint64_t, kIndexBits>;

constexpr std::uint64_t digit(int k) { return std::uint64_t{1} << (kDigits - 1 - k); }

/// Direction numbers of dimension j, from 0 (Joe and Kuo 2008, eqs. 2 to 4).
Directions directions(int j)
{
    using Table = boost::random::detail::qrng_tables::sobol;
    Directions m{}; // odd integers m_k, then as binary fractions m_k / 2^k
    m.fill(1);
    if (j > 0) {
        const auto row = static_cast<std::size_t>(j - 1);
        const unsigned polynomial = Table::polynomial(row);
        const int degree = std::bit_width(polynomial) - 1;
        for (int k = 0; k < degree; ++k) m[k] = Table::minit(row, static_cast<std::size_t>(k));
        for (int k = degree; k < kIndexBits; ++k) {
            m[k] = m[k - degree];
            for (int r = 1; r <= degree; ++r)
                if (polynomial >> (degree - r) & 1U) m[k] ^= m[k - r] << r;
        }
    }
    for (int k = 0; k < kIndexBits; ++k) m[k] <<= kDigits - 1 - k;
    return m;
}

/// Multiplies each by the lower triangular matrix whose columns are drawn from the stream.
void scramble_digits(Directions& v, Stream& stream)
{
    std::array<std::uint64_t, kDigits> column{};
    for (int k = 0; k < kDigits; ++k) column[k] = digit(k) | (stream.bits() & (digit(k) - 1));
    for (std::uint64_t& x : v) {
        std::uint64_t product = 0;
        for (int k = 0; k < kDigits; ++k)
            if (x & digit(k)) product ^= column[k];
        x = product;
    }
}

} // namespace

Eigen::MatrixXd sobol(std::int64_t first, std::int64_t last, int d, std::uint64_t seed,
                      Scramble scramble)
{
    if (d < 1 || d > kSobolDimensions)
        throw std::invalid_argument("sobol: variables are " + std::to_string(d) +
                                    "; allowed: 1 to 3667, use monte_carlo or latin_random");
    Eigen::MatrixXd u(last - first, d);
    for (int j = 0; j < d; ++j) {
        Directions v = directions(j);
        std::uint64_t x = 0; // the shift, then point by point
        if (scramble == Scramble::matrix_and_shift) {
            Stream stream(seed, static_cast<std::uint64_t>(j), Purpose::scramble);
            scramble_digits(v, stream);
            x = stream.bits() >> (64 - kDigits);
        }
        const auto start = static_cast<std::uint64_t>(first);
        for (int k = 0; k < kIndexBits;
             ++k) // Gray code: point i from point i - 1 by one change
            if ((start ^ start >> 1) >> k & 1U) x ^= v[k];
        for (std::int64_t i = first; i < last; ++i) {
            u(i - first, j) = (static_cast<double>(x) + 0.5) * 0x1p-52;
            const int changed = std::countr_zero(static_cast<std::uint64_t>(i + 1));
            if (changed < kIndexBits) x ^= v[changed];
        }
    }
    return u;
}

} // namespace uq
