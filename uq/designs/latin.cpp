#include "uq/designs/latin.hpp"

#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace uq {
namespace {

using Strata = std::vector<std::int32_t>;

void shuffle(Strata& s, Stream& stream)
{
    for (std::size_t i = s.size(); i > 1; --i) // Fisher-Yates; std::shuffle differs by library
        std::swap(s[i - 1], s[stream.below(i)]);
}

/// In (0, 1), 2^-31 away from either end.
double place_from(std::uint64_t bits)
{
    return (static_cast<double>(bits >> 34) + 0.5) * 0x1p-30;
}

/// From strata (as doubles in u) to places in them; rows of u are rows `first` .. of the
/// design.
void set_places(Eigen::Ref<Eigen::MatrixXd> u, std::int64_t n, std::uint64_t seed, Place place,
                std::int64_t first)
{
    const double strata = static_cast<double>(n);
    if (place == Place::centred) {
        for (double& x : u.reshaped()) x = (x + 0.5) / strata;
        return;
    }
    constexpr Eigen::Index kRows = 64; // at a time, so that columns are written in stretches
    for (Eigen::Index top = 0; top < u.rows(); top += kRows) {
        const Eigen::Index bottom = std::min(top + kRows, u.rows());
        for (Eigen::Index i = top; i < bottom; ++i) {
            Stream stream(seed, static_cast<std::uint64_t>(first + i),
                          Purpose::place_in_stratum);
            for (Eigen::Index j = 0; j < u.cols(); ++j)
                u(i, j) = (u(i, j) + place_from(stream.bits())) / strata;
        }
    }
}

void check_rows(std::int64_t n)
{
    constexpr std::int64_t kMost = std::int64_t{1}
                                   << 20; // strata and 30 bits of place in a double
    if (n < 1 || n > kMost)
        throw std::invalid_argument("latin hypercube: rows are " + std::to_string(n) +
                                    "; allowed: 1 to 1048576");
}

/// Rows in each of m strata of one variable.
std::vector<std::int32_t> occupation(const Eigen::MatrixXd& u, Eigen::Index j, std::int64_t m)
{
    std::vector<std::int32_t> count(static_cast<std::size_t>(m));
    for (Eigen::Index i = 0; i < u.rows(); ++i)
        ++count[static_cast<std::size_t>(stratum(u(i, j), m))];
    return count;
}

/// Empty strata in random order.
Strata empty_strata(const std::vector<std::int32_t>& count, Stream& stream)
{
    Strata empty;
    for (std::size_t s = 0; s < count.size(); ++s)
        if (count[s] == 0) empty.push_back(static_cast<std::int32_t>(s));
    shuffle(empty, stream);
    return empty;
}

} // namespace

std::int64_t stratum(double u, std::int64_t n)
{
    return std::min(n - 1, static_cast<std::int64_t>(u * static_cast<double>(n)));
}

Eigen::MatrixXd latin_hypercube(std::int64_t n, int d, std::uint64_t seed, Place place,
                                std::int64_t first, std::int64_t last)
{
    check_rows(n);
    Eigen::MatrixXd u(last - first, d);
    Strata order(static_cast<std::size_t>(n));
    for (int j = 0; j < d; ++j) {
        std::iota(order.begin(), order.end(), 0);
        Stream stream(seed, static_cast<std::uint64_t>(j), Purpose::strata);
        shuffle(order, stream);
        for (std::int64_t i = first; i < last; ++i)
            u(i - first, j) = order[static_cast<std::size_t>(i)];
    }
    set_places(u, n, seed, place, first);
    return u;
}

Eigen::MatrixXd grow_latin(const Eigen::MatrixXd& old, std::int64_t m, std::uint64_t seed,
                           Place place)
{
    check_rows(m);
    if (m <= old.rows())
        throw std::invalid_argument("latin hypercube: grown from " +
                                    std::to_string(old.rows()) + " rows to " +
                                    std::to_string(m) + "; allowed: to more rows");
    if (!(old.array() > 0.0 && old.array() < 1.0).all())
        throw std::invalid_argument("latin hypercube: an entry to grow from is not in (0, 1)");
    Eigen::MatrixXd grown(m, old.cols());
    grown.topRows(old.rows()) = old;
    auto added = grown.bottomRows(m - old.rows());
    for (Eigen::Index j = 0; j < old.cols(); ++j) {
        const auto count = occupation(old, j, m);
        // m is part of the key: each growth has its own stream
        Stream stream(seed, static_cast<std::uint64_t>(m << 32 | j), Purpose::extension);
        const Strata strata = empty_strata(count, stream); // at least as many as new rows
        for (Eigen::Index i = 0; i < added.rows(); ++i)
            added(i, j) = strata[static_cast<std::size_t>(i)];
    }
    set_places(added, m, seed, place, old.rows());
    return grown;
}

} // namespace uq
