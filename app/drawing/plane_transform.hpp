#pragma once
/// Transforms of the plane that drawings place their parts by.

namespace app {

/// x' = a x + c y + e, y' = b x + d y + f.
struct PlaneTransform {
    double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;
};

/// First the inner, then the outer one.
[[nodiscard]] inline PlaneTransform operator*(const PlaneTransform& o, const PlaneTransform& i)
{
    return {o.a * i.a + o.c * i.b, o.b * i.a + o.d * i.b,       o.a * i.c + o.c * i.d,
            o.b * i.c + o.d * i.d, o.a * i.e + o.c * i.f + o.e, o.b * i.e + o.d * i.f + o.f};
}

} // namespace app
