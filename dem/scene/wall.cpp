#include "dem/scene/wall.hpp"

namespace dem {

double joint_stiffness(double h, double wall_modulus, double stone_modulus)
{
    return 1.0 / (h * (1.0 / wall_modulus - 1.0 / stone_modulus));
}

double shear_stiffness(double kn, double poisson_ratio)
{
    return kn / (2.0 * (1.0 + poisson_ratio));
}

} // namespace dem
