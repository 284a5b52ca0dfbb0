#include "uq/designs/design.hpp"

#include "uq/designs/latin.hpp"
#include "uq/designs/latin_annealing.hpp"
#include "uq/designs/sobol.hpp"
#include "uq/designs/stream.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>

namespace uq {
namespace {

bool is_optimised(DesignKind kind) { return kind == DesignKind::latin_optimised; }

Place place_of(DesignKind kind)
{
    return kind == DesignKind::latin_centred ? Place::centred : Place::random;
}

Eigen::MatrixXd independent(const Design& design, std::int64_t first, std::int64_t last)
{
    Eigen::MatrixXd u(last - first, design.d);
    std::vector<double> row(static_cast<std::size_t>(design.d));
    for (std::int64_t i = first; i < last; ++i) {
        Stream stream(design.seed, static_cast<std::uint64_t>(i), Purpose::monte_carlo);
        stream.fill_uniform(row);
        u.row(i - first) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), design.d);
    }
    return u;
}

Eigen::MatrixXd whole_latin(const Design& design)
{
    const Place place = place_of(design.kind);
    const bool spread = is_optimised(design.kind);
    Eigen::MatrixXd u =
        latin_hypercube(design.sizes[0], design.d, design.seed, place, 0, design.sizes[0]);
    if (spread) u = spread_rows(std::move(u), 0, design.seed);
    for (std::size_t k = 1; k < design.sizes.size(); ++k) {
        u = grow_latin(u, design.sizes[k], design.seed, place);
        if (spread) u = spread_rows(std::move(u), design.sizes[k - 1], design.seed);
    }
    return u;
}

} // namespace

bool is_latin(DesignKind kind)
{
    return kind != DesignKind::monte_carlo && kind != DesignKind::sobol;
}

std::int64_t rows(const Design& design) { return design.sizes.back(); }

void check(const Design& design)
{
    const std::int64_t most = std::int64_t{1} << (is_latin(design.kind) ? 20 : 32);
    if (design.d < 1)
        throw std::invalid_argument("design: variables are " + std::to_string(design.d) +
                                    "; allowed: 1 at least");
    if (design.sizes.empty()) throw std::invalid_argument("design: no size; one at least");
    std::int64_t before = 0;
    for (const std::int64_t n : design.sizes) {
        if (n <= before || n > most)
            throw std::invalid_argument("design: a size is " + std::to_string(n) +
                                        "; allowed: ascending, 1 to " + std::to_string(most));
        before = n;
    }
    if (is_optimised(design.kind) && before > 4096)
        throw std::invalid_argument("design: an optimised latin hypercube of " +
                                    std::to_string(before) + " rows; allowed: at most 4096");
    if (design.kind == DesignKind::sobol && design.d > kSobolDimensions)
        throw std::invalid_argument(
            "design: sobol in " + std::to_string(design.d) +
            " variables; allowed: at most 3667, use monte_carlo or latin_random");
}

void check(const Design& design, std::int64_t first, std::int64_t last)
{
    check(design);
    if (first < 0 || first > last || last > rows(design))
        throw std::invalid_argument("design: rows " + std::to_string(first) + " to " +
                                    std::to_string(last) + " of " +
                                    std::to_string(rows(design)) + " asked for");
}

Eigen::MatrixXd unit_cube(const Design& design)
{
    check(design);
    return unit_cube(design, 0, rows(design));
}

Eigen::MatrixXd unit_cube(const Design& design, std::int64_t first, std::int64_t last)
{
    check(design, first, last);
    if (design.kind == DesignKind::monte_carlo) return independent(design, first, last);
    if (design.kind == DesignKind::sobol) return sobol(first, last, design.d, design.seed);
    if (design.sizes.size() == 1 && !is_optimised(design.kind))
        return latin_hypercube(design.sizes[0], design.d, design.seed, place_of(design.kind),
                               first, last);
    return whole_latin(design).middleRows(first, last - first);
}

} // namespace uq
