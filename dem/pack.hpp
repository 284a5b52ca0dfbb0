#pragma once
/// A register of doubles, one wall per lane. Laws and solver are written once over Real =
/// double or Pack. Untemplated: g++ 12 refuses a dependent vector_size. Build with
/// -ffp-contract=off: multiply_add is the only place where a product and a sum are rounded
/// once, so every width and compiler gives the same bits.

#include <algorithm>
#include <cmath>
#include <cstdint>

#if defined(__AVX512F__) || defined(__FMA__)
#include <immintrin.h>
#endif

namespace dem {

#if defined(__AVX512F__)
constexpr int kLanes = 8;
#elif defined(__AVX__)
constexpr int kLanes = 4;
#else
constexpr int kLanes = 2;
#endif

class Pack {
    using Vector = double __attribute__((vector_size(kLanes * sizeof(double))));
    using Bits = std::int64_t __attribute__((vector_size(kLanes * sizeof(double))));

  public:
    /// All bits of a lane set where true.
    struct Mask {
        Bits bits;
        friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
        friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
    };

    Pack() = default;
    Pack(double x)
        : v_(Vector{} + x) {} // NOLINT: every constant of a law is one value for all lanes
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
    friend Pack multiply_add(Pack a, Pack b, Pack c)
    {
#if defined(__AVX512F__)
        return Pack(Vector(_mm512_fmadd_pd(a.v_, b.v_, c.v_)));
#elif defined(__FMA__)
        return Pack(Vector(_mm256_fmadd_pd(a.v_, b.v_, c.v_)));
#else
        for (int i = 0; i < kLanes; ++i) c.v_[i] = std::fma(a.v_[i], b.v_[i], c.v_[i]);
        return c;
#endif
    }

  private:
    explicit Pack(Vector v) : v_(v) {}
    Vector v_;
};

inline Pack min(Pack a, Pack b) { return select(b < a, b, a); }
inline Pack max(Pack a, Pack b) { return select(a < b, b, a); }
inline Pack abs(Pack a) { return max(a, -a); }

inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline double multiply_add(double a, double b, double c) { return std::fma(a, b, c); }
inline double min(double a, double b) { return b < a ? b : a; }
inline double max(double a, double b) { return a < b ? b : a; }
inline double abs(double a) { return max(a, -a); }

/// Number of walls in one Real, and access to one of them.
template <class Real> constexpr int lanes = 1;
template <> inline constexpr int lanes<Pack> = kLanes;
inline double lane(double x, int) { return x; }
inline double lane(Pack x, int i) { return x[i]; }
inline void set_lane(double& x, int, double value) { x = value; }
inline void set_lane(Pack& x, int i, double value) { x.set(i, value); }

} // namespace dem
