#pragma once
/// The linear map between the modes of a block and its contacts; all lanes share one matrix. A
/// port is a contact as one of its two blocks sees it. It has two rows, normal and tangential,
/// and an index tells where its contact stands in the arrays of contacts.
///   modal force += sum over ports of to_modes x (sigma, tau)
///   relative displacement (du_n, du_s) of the contact += to_contacts x modal velocity

#include "dem/contact/own_matrix.hpp"
#include "dem/contact/pack.hpp"

#include <cstddef>
#include <vector>

namespace dem {

struct ContactOperator {
    int ports = 0;
    int modes = 0;
    std::vector<double> to_modes;    ///< 2 ports x modes, row-major [m2 m/sqrt(J)]
    std::vector<double> to_contacts; ///< modes x 2 ports, row-major [m/sqrt(J)]
    std::vector<double> own;         ///< in place of both, see own_matrix.hpp
};

/// The same, with its matrix stored once.
[[nodiscard]] ContactOperator with_own_matrix(const ContactOperator& a);

/// [bytes]
[[nodiscard]] inline std::size_t bytes_of(const ContactOperator& a)
{
    return sizeof(double) * (a.to_modes.size() + a.to_contacts.size() + a.own.size());
}

namespace detail {

/// Forms kBlock sums at a time, so that they stay in registers. The terms of each sum are added
/// in the same order whatever kBlock is.
template <int kBlock, class Real>
void gather_block(const ContactOperator& a, const int* contact, const Real* stress, int first,
                  Real* modal)
{
    Real sum[kBlock];
#pragma GCC unroll 16
    for (int j = 0; j < kBlock; ++j) sum[j] = Real(0.0);
    const double* row = a.to_modes.data() + first;
    for (int p = 0; p < a.ports; ++p) {
        const Real sigma = stress[2 * contact[p]], tau = stress[2 * contact[p] + 1];
#pragma GCC unroll 16
        for (int j = 0; j < kBlock; ++j) sum[j] = multiply_add(Real(row[j]), sigma, sum[j]);
        row += a.modes;
#pragma GCC unroll 16
        for (int j = 0; j < kBlock; ++j) sum[j] = multiply_add(Real(row[j]), tau, sum[j]);
        row += a.modes;
    }
#pragma GCC unroll 16
    for (int j = 0; j < kBlock; ++j) modal[first + j] = sum[j];
}

/// Treats kPorts ports at a time.
template <int kPorts, class Real>
void scatter_block(const ContactOperator& a, const int* contact, const Real* velocity,
                   int first, Real* du)
{
    constexpr int kBlock = 2 * kPorts;
    Real sum[kBlock];
#pragma GCC unroll 16
    for (int j = 0; j < kBlock; ++j) sum[j] = Real(0.0);
    const double* row = a.to_contacts.data() + static_cast<std::ptrdiff_t>(2) * first;
    for (int i = 0; i < a.modes; ++i, row += 2 * a.ports) {
        const Real v = velocity[i];
#pragma GCC unroll 16
        for (int j = 0; j < kBlock; ++j) sum[j] = multiply_add(Real(row[j]), v, sum[j]);
    }
#pragma GCC unroll 16
    for (int p = 0; p < kPorts; ++p) {
        Real* at = du + 2 * contact[first + p];
        at[0] += sum[2 * p];
        at[1] += sum[2 * p + 1];
    }
}

} // namespace detail

/// Modal forces from contact stresses.
/// @param contact index of each port's contact;  area: of each contact [m2]
/// @param stress (sigma, tau) of each contact [Pa]
template <class Real>
void gather(const ContactOperator& a, const int* contact, const double* area,
            const Real* stress, Real* modal)
{
    if (!a.own.empty())
        return detail::gather_own(a.own.data(), a.modes, a.ports, contact, area, stress, modal);
    // A few sums at a time would wait for one another: each of these passes takes as many as
    // there are.
    int j = 0;
    for (; j + 16 <= a.modes; j += 16) detail::gather_block<16>(a, contact, stress, j, modal);
    for (; j + 12 <= a.modes; j += 12) detail::gather_block<12>(a, contact, stress, j, modal);
    for (; j + 9 <= a.modes; j += 9) detail::gather_block<9>(a, contact, stress, j, modal);
    for (; j + 6 <= a.modes; j += 6) detail::gather_block<6>(a, contact, stress, j, modal);
    for (; j + 3 <= a.modes; j += 3) detail::gather_block<3>(a, contact, stress, j, modal);
    for (; j < a.modes; ++j) detail::gather_block<1>(a, contact, stress, j, modal);
}

/// Adds the relative displacements of the contacts that the modal velocities make in a step.
/// @param du (normal, tangential) of each contact [m]
template <class Real>
void scatter(const ContactOperator& a, const int* contact, const Real* velocity, Real* du)
{
    if (!a.own.empty())
        return detail::scatter_own(a.own.data(), a.modes, a.ports, contact, velocity, du);
    int p = 0;
    for (; p + 8 <= a.ports; p += 8) detail::scatter_block<8>(a, contact, velocity, p, du);
    for (; p + 4 <= a.ports; p += 4) detail::scatter_block<4>(a, contact, velocity, p, du);
    for (; p < a.ports; ++p) detail::scatter_block<1>(a, contact, velocity, p, du);
}

} // namespace dem
