#pragma once
/// y = A^T x for one matrix shared by all lanes: the block elasticity's share of a step.

#include "dem/pack.hpp"

#include <cstddef>
#include <vector>

namespace dem {

/// Row-major, one row per input.
struct SharedMatrix {
    int inputs = 0;
    int outputs = 0;
    std::vector<double> values; ///< inputs x outputs
};

namespace detail {

/// kBlock outputs at a time stay in registers. The order of the sum is that of the inputs,
/// whatever the block.
template <int kBlock, class Real>
void apply_block(const SharedMatrix& a, int first, const Real* x, Real* y)
{
    Real sum[kBlock];
    for (int j = 0; j < kBlock; ++j) sum[j] = Real(0.0);
    const double* row = a.values.data() + first;
    for (int i = 0; i < a.inputs; ++i, row += a.outputs) {
        const Real xi = x[i];
        for (int j = 0; j < kBlock; ++j) sum[j] = multiply_add(Real(row[j]), xi, sum[j]);
    }
    for (int j = 0; j < kBlock; ++j) y[first + j] = sum[j];
}

} // namespace detail

/// y_j = sum_i a_ij x_i
template <class Real> void apply(const SharedMatrix& a, const Real* x, Real* y)
{
    int j = 0;
    for (; j + 16 <= a.outputs; j += 16) detail::apply_block<16>(a, j, x, y);
    for (; j + 8 <= a.outputs; j += 8) detail::apply_block<8>(a, j, x, y);
    for (; j + 4 <= a.outputs; j += 4) detail::apply_block<4>(a, j, x, y);
    for (; j < a.outputs; ++j) detail::apply_block<1>(a, j, x, y);
}

} // namespace dem
