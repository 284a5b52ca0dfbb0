#include "core/row_products.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace core {

namespace {

#ifdef __AVX__
constexpr Eigen::Index kLanes = 4;
#else
constexpr Eigen::Index kLanes = 2; // split by the compiler, four would leave the registers
#endif
constexpr Eigen::Index kSamples =
    2 * kLanes;                   ///< side by side, one in each lane of two registers
constexpr Eigen::Index kRows = 4; ///< of the map, so that a loaded coordinate serves four sums

/// Lanes never meet, so the bits do not depend on their number.
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));

Lanes load(const double* from)
{
    Lanes x;
    std::memcpy(&x, from, sizeof x);
    return x;
}

struct Panel {
    Eigen::Index reach;         ///< coordinates up to the last that is not zero
    std::vector<double> values; ///< reach x kRows
};

Panel panel(const Eigen::MatrixXd& map, Eigen::Index first)
{
    const Eigen::Index rows = std::min(kRows, map.rows() - first);
    Panel p{map.cols(), {}};
    while (p.reach > 0 && map.block(first, p.reach - 1, rows, 1).isZero(0.0)) --p.reach;
    p.values.assign(static_cast<std::size_t>(p.reach * kRows), 0.0);
    for (Eigen::Index j = 0; j < p.reach; ++j)
        for (Eigen::Index i = 0; i < rows; ++i)
            p.values[static_cast<std::size_t>(j * kRows + i)] = map(first + i, j);
    return p;
}

/// `out`: kRows x kSamples sums over the coordinates of `z`: reach x kSamples.
void sum(const Panel& p, const double* z, double* out)
{
    Lanes a0{}, a1{}, b0{}, b1{}, c0{}, c1{}, d0{}, d1{};
    const double* m = p.values.data();
    for (Eigen::Index j = 0; j < p.reach; ++j, m += kRows, z += kSamples) {
        const Lanes x0 = load(z), x1 = load(z + kLanes);
        a0 += m[0] * x0;
        a1 += m[0] * x1;
        b0 += m[1] * x0;
        b1 += m[1] * x1;
        c0 += m[2] * x0;
        c1 += m[2] * x1;
        d0 += m[3] * x0;
        d1 += m[3] * x1;
    }
    for (const Lanes& sums : {a0, a1, b0, b1, c0, c1, d0, d1}) {
        std::memcpy(out, &sums, sizeof sums);
        out += kLanes;
    }
}

} // namespace

Eigen::MatrixXd times_transposed(const Eigen::MatrixXd& z, const Eigen::MatrixXd& map)
{
    std::vector<Panel> panels;
    for (Eigen::Index i = 0; i < map.rows(); i += kRows) panels.push_back(panel(map, i));
    Eigen::MatrixXd g(z.rows(), map.rows());
    std::vector<double> side_by_side(static_cast<std::size_t>(z.cols() * kSamples), 0.0);
    for (Eigen::Index s = 0; s < z.rows(); s += kSamples) {
        const Eigen::Index n = std::min(kSamples, z.rows() - s);
        for (Eigen::Index j = 0; j < z.cols(); ++j)
            std::copy_n(z.data() + j * z.rows() + s, n, side_by_side.data() + j * kSamples);
        for (std::size_t k = 0; k < panels.size(); ++k) {
            double sums[kRows * kSamples];
            sum(panels[k], side_by_side.data(), sums);
            const Eigen::Index first = static_cast<Eigen::Index>(k) * kRows;
            for (Eigen::Index i = 0; i < std::min(kRows, map.rows() - first); ++i)
                std::copy_n(sums + i * kSamples, n, g.data() + (first + i) * g.rows() + s);
        }
    }
    return g;
}

} // namespace core
