#include <cmath>

int main()
{
    const ground::GroundMotion m = ground::pulse("half_sine(peak 0.5 g, duration 0.3 s)");
    return std::abs(ground::motion_facts(m).pga - 0.5 * ground::kGravity) < 1e-12 ? 0 : 1;
}
