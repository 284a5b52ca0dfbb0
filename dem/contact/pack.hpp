#pragma once
/// A register of numbers, one wall per lane. Laws and solver are written once over Real = double,
/// float or a pack of either. Build with -ffp-contract=off: multiply_add is the only place where
/// a product and a sum are rounded once, so every width and compiler gives the same bits.

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

/// What a register of T is to the compiler. g++ 12 refuses a vector_size that depends on T.
template <class T> struct Register;
template <> struct Register<double> {
    using Vector = double __attribute__((vector_size(kRegisterBytes)));
    using Bits = std::int64_t __attribute__((vector_size(kRegisterBytes)));
};
template <> struct Register<float> {
    using Vector = float __attribute__((vector_size(kRegisterBytes)));
    using Bits = std::int32_t __attribute__((vector_size(kRegisterBytes)));
};

template <class T> class PackOf {
    using Vector = typename Register<T>::Vector;
    using Bits = typename Register<T>::Bits;
    static constexpr int kLanes = kRegisterBytes / sizeof(T);

  public:
    /// All bits of a lane set where true.
    struct Mask {
        Bits bits;
        friend Mask operator&(Mask a, Mask b) { return {a.bits & b.bits}; }
        friend Mask operator|(Mask a, Mask b) { return {a.bits | b.bits}; }
    };

    PackOf() = default;
    PackOf(T x) : v_(broadcast(x)) {} // NOLINT: a constant of a law is one value for all lanes
    [[nodiscard]] T operator[](int lane) const { return v_[lane]; }
    void set(int lane, T x) { v_[lane] = x; }

    friend PackOf operator+(PackOf a, PackOf b) { return PackOf(a.v_ + b.v_); }
    friend PackOf operator-(PackOf a, PackOf b) { return PackOf(a.v_ - b.v_); }
    friend PackOf operator*(PackOf a, PackOf b) { return PackOf(a.v_ * b.v_); }
    friend PackOf operator/(PackOf a, PackOf b) { return PackOf(a.v_ / b.v_); }
    friend PackOf operator-(PackOf a) { return PackOf(-a.v_); }
    PackOf& operator+=(PackOf b) { return *this = *this + b; }
    PackOf& operator-=(PackOf b) { return *this = *this - b; }
    friend Mask operator<(PackOf a, PackOf b) { return {a.v_ < b.v_}; }
    friend Mask operator>(PackOf a, PackOf b) { return {a.v_ > b.v_}; }
    friend PackOf select(Mask m, PackOf yes, PackOf no)
    {
        return PackOf(m.bits ? yes.v_ : no.v_);
    }
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
    friend PackOf multiply_add(PackOf a, PackOf b, PackOf c)
    {
#if defined(__AVX512F__)
        return PackOf(fused(a.v_, b.v_, c.v_));
#elif defined(__FMA__)
        return PackOf(fused(a.v_, b.v_, c.v_));
#else
        for (int i = 0; i < kLanes; ++i) c.v_[i] = std::fma(a.v_[i], b.v_[i], c.v_[i]);
        return c;
#endif
    }

  private:
    explicit PackOf(Vector v) : v_(v) {}
#if defined(__AVX512F__)
    static __m512d broadcast(double x) { return _mm512_set1_pd(x); }
    static __m512 broadcast(float x) { return _mm512_set1_ps(x); }
#elif defined(__AVX__)
    static __m256d broadcast(double x) { return _mm256_set1_pd(x); }
    static __m256 broadcast(float x) { return _mm256_set1_ps(x); }
#else
    static Vector broadcast(T x)
    {
        Vector v;
        for (int i = 0; i < kLanes; ++i) v[i] = x;
        return v;
    }
#endif
#if defined(__AVX512F__)
    static __m512d fused(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
    static __m512 fused(__m512 a, __m512 b, __m512 c) { return _mm512_fmadd_ps(a, b, c); }
#elif defined(__FMA__)
    static __m256d fused(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
    static __m256 fused(__m256 a, __m256 b, __m256 c) { return _mm256_fmadd_ps(a, b, c); }
#endif
    Vector v_;
};

using Pack = PackOf<double>;
using FloatPack = PackOf<float>;

inline double select(bool mask, double yes, double no) { return mask ? yes : no; }
inline float select(bool mask, float yes, float no) { return mask ? yes : no; }
inline bool any(bool mask) { return mask; }
inline double multiply_add(double a, double b, double c) { return std::fma(a, b, c); }
inline float multiply_add(float a, float b, float c) { return std::fma(a, b, c); }

/// b where it is smaller, else a.
template <class Real> Real min(Real a, Real b) { return select(b < a, b, a); }
template <class Real> Real max(Real a, Real b) { return select(a < b, b, a); }
template <class Real> Real abs(Real a) { return max(a, -a); }

/// Number of walls in one Real, and access to one of them.
template <class Real> inline constexpr int lanes = 1;
template <class T> inline constexpr int lanes<PackOf<T>> = kRegisterBytes / sizeof(T);
template <class T> inline constexpr bool is_pack = false;
template <class T> inline constexpr bool is_pack<PackOf<T>> = true;

/// The numbers in a Real: double or float.
template <class Real> struct NumberOf {
    using Type = Real;
};
template <class T> struct NumberOf<PackOf<T>> {
    using Type = T;
};
template <class Real> using Number = typename NumberOf<Real>::Type;

template <class Real> double lane(Real x, int i)
{
    if constexpr (is_pack<Real>)
        return x[i];
    else
        return x;
}
template <class Real> void set_lane(Real& x, int i, double value)
{
    if constexpr (is_pack<Real>)
        x.set(i, value);
    else
        x = static_cast<Real>(value);
}

} // namespace dem
