#pragma once
/// The products of ContactOperator with a matrix that is stored once. Stones of all shapes have
/// one each, and some hundred of them do not fit the second cache: to fetch their numbers then
/// takes longer than to compute with them. Blocks that share a matrix store it twice, in the
/// order of either product.
///
/// Two ports make a tile of four rows, which fills a register where a wall is alone. The matrix
/// is
///   tiles x modes x 4 rows [m/sqrt(J)],
/// with zeros for the rows that an odd last port lacks. Sums over the rows are taken in four
/// parts, whatever the register.

#include "dem/contact/pack.hpp"

#include <cstddef>

namespace dem::detail {

constexpr int kTileRows = 4; ///< (normal, tangential) of two ports

/// One number for each of the rows of a tile, for each wall of a Real.
template <class Real> class TileRows {
  public:
    TileRows() : TileRows(Real(0.0)) {}
    explicit TileRows(Real all) : row_{all, all, all, all} {}
    TileRows(Real a, Real b, Real c, Real d) : row_{a, b, c, d} {}
    [[nodiscard]] Real operator[](int r) const { return row_[r]; }
    void add(const double* matrix, const TileRows& by)
    {
#pragma GCC unroll 4
        for (int r = 0; r < kTileRows; ++r)
            row_[r] = multiply_add(Real(matrix[r]), by.row_[r], row_[r]);
    }

  private:
    Real row_[kTileRows];
};

#if defined(__AVX__) && defined(__FMA__)
/// One register holds the rows of one wall.
template <> class TileRows<double> {
  public:
    TileRows() : rows_(_mm256_setzero_pd()) {}
    explicit TileRows(double all) : rows_(_mm256_set1_pd(all)) {}
    TileRows(double a, double b, double c, double d) : rows_(_mm256_setr_pd(a, b, c, d)) {}
    [[nodiscard]] double operator[](int r) const { return rows_[r]; }
    void add(const double* matrix, const TileRows& by)
    {
        rows_ = _mm256_fmadd_pd(_mm256_loadu_pd(matrix), by.rows_, rows_);
    }

  private:
    __m256d rows_;
};
#endif

/// The forces of the ports of a tile, against the motion of their contacts [N].
template <class Real>
TileRows<Real> tile_force(const int* contact, int ports, const double* area, const Real* stress)
{
    const int a = contact[0], b = contact[ports > 1 ? 1 : 0];
    const Real on_a(-area[a]), on_b(-area[b]);
    return {on_a * stress[2 * a], on_a * stress[2 * a + 1], on_b * stress[2 * b],
            on_b * stress[2 * b + 1]};
}

/// Modal forces of kModes modes, from `first` on.
template <int kModes, class Real>
void gather_tiles(const double* matrix, int modes, int first, int ports, const int* contact,
                  const double* area, const Real* stress, Real* modal)
{
    TileRows<Real> sum[kModes];
    matrix += kTileRows * first;
    for (int p = 0; p < ports; p += 2, matrix += kTileRows * modes) {
        const TileRows<Real> force = tile_force(contact + p, ports - p, area, stress);
#pragma GCC unroll 16
        for (int i = 0; i < kModes; ++i) sum[i].add(matrix + kTileRows * i, force);
    }
#pragma GCC unroll 16
    for (int i = 0; i < kModes; ++i)
        modal[first + i] = (sum[i][0] + sum[i][2]) + (sum[i][1] + sum[i][3]);
}

/// See gather() of ContactOperator.
template <class Real>
void gather_own(const double* matrix, int modes, int ports, const int* contact,
                const double* area, const Real* stress, Real* modal)
{
    int i = 0;
    const auto pass = [&]<int kModes>() {
        for (; i + kModes <= modes; i += kModes)
            gather_tiles<kModes>(matrix, modes, i, ports, contact, area, stress, modal);
    };
    // As many sums as there are registers for, beside those of the forces.
    if constexpr (lanes<Real> == 1) pass.template operator()<12>();
    if constexpr (lanes<Real> == 1) pass.template operator()<9>();
    if constexpr (lanes<Real> == 1 || kRegisterBytes == 64) pass.template operator()<6>();
    pass.template operator()<3>();
    pass.template operator()<1>();
}

/// See scatter() of ContactOperator.
template <class Real>
void scatter_own(const double* matrix, int modes, int ports, const int* contact,
                 const Real* velocity, Real* du)
{
    for (int p = 0; p < ports; p += 2) {
        TileRows<Real> sum;
        for (int i = 0; i < modes; ++i, matrix += kTileRows)
            sum.add(matrix, TileRows<Real>(velocity[i]));
        for (int q = 0; q < 2 && p + q < ports; ++q) {
            Real* at = du + std::ptrdiff_t{2} * contact[p + q];
            at[0] += sum[2 * q];
            at[1] += sum[2 * q + 1];
        }
    }
}

} // namespace dem::detail
