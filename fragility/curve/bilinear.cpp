#include "fragility/curve/bilinear.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fragility {
namespace {

/// Rounding of d_u^2: a straight curve has d_u^2 = 2 E / k, and must not fail by rounding.
constexpr double kRootRounding = 1e-12;

Bilinear failed(BilinearOutcome why)
{
    Bilinear b;
    b.outcome = why;
    return b;
}

} // namespace

std::string_view reason(BilinearOutcome outcome)
{
    switch (outcome) {
    case BilinearOutcome::found:
        return {};
    case BilinearOutcome::no_positive_force:
        return "the force is nowhere positive";
    case BilinearOutcome::no_elastic_branch:
        return "no elastic branch: the force is there at zero displacement";
    case BilinearOutcome::ultimate_before_share:
        return "no elastic branch: the ultimate displacement comes before it is reached";
    case BilinearOutcome::no_positive_area:
        return "no energy up to the ultimate displacement";
    case BilinearOutcome::no_real_root:
        return "no bilinear of equal energy: the curve stiffens above its elastic branch";
    }
    return "unknown";
}

Bilinear equal_energy_bilinear(const Curve& curve, double ultimate, double share)
{
    const double energy = area(curve, ultimate);
    const std::optional<double> stiffness = secant_stiffness(curve, share);
    const double force = share * peak(curve).force;
    if (!(force > 0.0)) return failed(BilinearOutcome::no_positive_force);
    if (!stiffness) return failed(BilinearOutcome::no_elastic_branch);
    if (ultimate < first_reaching(curve, force).value())
        return failed(BilinearOutcome::ultimate_before_share);
    if (!(energy > 0.0)) return failed(BilinearOutcome::no_positive_area);

    const double square = ultimate * ultimate;
    const double twice = 2.0 * energy / *stiffness;
    if (square - twice < -kRootRounding * square) return failed(BilinearOutcome::no_real_root);

    Bilinear b;
    b.outcome = BilinearOutcome::found;
    b.stiffness = *stiffness;
    // the root of the header, without the difference of two close numbers
    b.yield_displacement =
        std::min(ultimate, twice / (ultimate + std::sqrt(std::max(0.0, square - twice))));
    b.yield_force = b.stiffness * b.yield_displacement;
    b.ultimate_displacement = ultimate;
    b.ductility = ultimate / b.yield_displacement;
    return b;
}

} // namespace fragility
