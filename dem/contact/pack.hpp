#pragma once
/// A processor register of doubles, one wall per lane. The laws and the solver are written
/// once, over Real = double or Pack. The build uses -ffp-contract=off, so multiply_add is the
/// only place where a product and a sum are rounded once, and every register width and compiler
/// gives the same bits. WebAssembly has no fused multiply-add, and in software one push takes
/// twelve times as long: there product and sum are rounded each, and the last digits differ.

#include <cmath>
#include <cstdint>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace dem {

#if defined(__AVX512F__)
constexpr int kRegisterBytes = 64;
#elif defined(__AVX__)
constexpr int kRegisterBytes = 32;
#else
constexpr int kRegisterBytes = 16;
#endif

/// 1 / sqrt(a) to seven digits, for 1e-30 < a < 1e30. No processor's own estimate is used, so
/// that all give the same bits.
inline double rough_inverse_root(double a)
{
    return static_cast<double>(1.0F / std::sqrt(static_cast<float>(a)));
}

class Pack {
    using Vector = double __attribute__((vector_size(kRegisterBytes)));
    using Bits = std::int64_t __attribute__((vector_size(kRegisterBytes)));
    static constexpr int kLanes = kRegisterBytes / sizeof(double);

  public:
    /// All bits of a lane set where true.
    struct Mask {
        Bits bits;
        friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
        friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
    };

    Pack() = default;
    Pack(double x)
        : v_(broadcast(x)) {} // NOLINT: a constant of a law is one value for all lanes
    [[nodiscard]] double operator[](int lane) const { return v_[lane]; }
    void set(int lane, double x) { v_[lane] = x; }

    friend Pack operator+(Pack a, Pack b) { return Pack(a.v_ + b.v_); }
    friend Pack operator-(Pack a, Pack b) { return Pack(a.v_ - b.v_); }
    friend Pack operator*(Pack a, Pack b) { return Pack(a.v_ * b.v_); }
    friend Pack operator/(Pack a, Pack b) { return Pack(a.v_ / b.v_); }
    friend Pack operator-(Pack a) { return Pack(-a.v_); }
    Pack& operator+=(Pack b) { return *this = *this + b; }
    Pack& operator-=(Pack b) { return *this = *this - b; }
    friend Mask operator<(Pack a, Pack b) { return {a.v_ < b.v_}; }
    friend Mask operator>(Pack a, Pack b) { return {a.v_ > b.v_}; }
    friend Pack select(Mask m, Pack yes, Pack no) { return Pack(m.bits ? yes.v_ : no.v_); }
    friend bool any(Mask m)
    {
        Bits bits = m.bits;
#if defined(__AVX512F__)
        const auto packed = reinterpret_cast<const __m512i&>(bits);
        return _mm512_test_epi64_mask(packed, packed) != 0;
#elif defined(__AVX__)
        const auto packed = reinterpret_cast<const __m256i&>(bits);
        return _mm256_testz_si256(packed, packed) == 0;
#else
        for (int i = 0; i < kLanes; ++i)
            if (bits[i] != 0) return true;
        return false;
#endif
    }
    friend Pack multiply_add(Pack a, Pack b, Pack c)
    {
#if defined(__AVX512F__)
        return Pack(fused(a.v_, b.v_, c.v_));
#elif defined(__FMA__)
        return Pack(fused(a.v_, b.v_, c.v_));
#elif defined(__wasm__)
        return a * b + c;
#else
        for (int i = 0; i < kLanes; ++i) c.v_[i] = std::fma(a.v_[i], b.v_[i], c.v_[i]);
        return c;
#endif
    }
    friend Pack sqrt(Pack a)
    {
#if defined(__AVX512F__)
        return Pack(root(a.v_));
#elif defined(__AVX__)
        return Pack(root(a.v_));
#else
        for (int i = 0; i < kLanes; ++i) a.v_[i] = std::sqrt(a.v_[i]);
        return a;
#endif
    }
    friend Pack rough_inverse_root(Pack a)
    {
#if defined(__AVX512F__)
        const __m256 root = _mm256_sqrt_ps(_mm512_maskz_cvtpd_ps(0xff, a.v_));
        return Pack(_mm512_maskz_cvtps_pd(0xff, _mm256_div_ps(_mm256_set1_ps(1.0F), root)));
#elif defined(__AVX__)
        return Pack(
            _mm256_cvtps_pd(_mm_div_ps(_mm_set1_ps(1.0F), _mm_sqrt_ps(_mm256_cvtpd_ps(a.v_)))));
#else
        for (int i = 0; i < kLanes; ++i) a.v_[i] = rough_inverse_root(a.v_[i]);
        return a;
#endif
    }

  private:
    explicit Pack(Vector v) : v_(v) {}
#if defined(__AVX512F__)
    static __m512d broadcast(double x) { return _mm512_set1_pd(x); }
#elif defined(__AVX__)
    static __m256d broadcast(double x) { return _mm256_set1_pd(x); }
#else
    static Vector broadcast(double x)
    {
        Vector v;
        for (int i = 0; i < kLanes; ++i) v[i] = x;
        return v;
    }
#endif
#if defined(__AVX512F__)
    /// (g++ 12 warns of _mm512_sqrt_pd.)
    static __m512d root(__m512d a) { return _mm512_maskz_sqrt_pd(0xff, a); }
#elif defined(__AVX__)
    static __m256d root(__m256d a) { return _mm256_sqrt_pd(a); }
#endif
#if defined(__AVX512F__)
    static __m512d fused(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
#elif defined(__FMA__)
    static __m256d fused(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
#endif
    Vector v_;
};

inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline bool any(bool mask) { return mask; }
#if defined(__wasm__)
inline double multiply_add(double a, double b, double c) { return a * b + c; }
#else
inline double multiply_add(double a, double b, double c) { return std::fma(a, b, c); }
#endif
using std::sqrt; // exact to the last bit, as that of Pack

/// b where it is smaller, else a.
template <class Real> Real min(Real a, Real b) { return select(b < a, b, a); }
template <class Real> Real max(Real a, Real b) { return select(a < b, b, a); }
template <class Real> Real abs(Real a) { return max(a, -a); }

/// 1 / sqrt(a) to some 1e-16, for 1e-30 < a < 1e30; quicker than a division and a root.
template <class Real> Real inverse_root(Real a)
{
    const Real r = rough_inverse_root(a), missing = multiply_add(-(a * r), r, Real(1.0));
    return multiply_add(r * missing, multiply_add(Real(0.375), missing, Real(0.5)), r);
}

/// Number of walls in one Real, and access to one of them.
template <class Real> inline constexpr int lanes = 1;
template <> inline constexpr int lanes<Pack> = kRegisterBytes / sizeof(double);

inline double lane(double x, int) { return x; }
inline double lane(Pack x, int i) { return x[i]; }
inline void set_lane(double& x, int, double value) { x = value; }
inline void set_lane(Pack& x, int i, double value) { x.set(i, value); }

} // namespace dem
