#include "ground/motion_facts.hpp"

#include "ground/record_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ground {

MotionFacts motion_facts(const GroundMotion& motion)
{
    MotionFacts f;
    const Trace t = integrated(motion);
    const auto largest = [](const std::vector<double>& line) {
        double most = 0.0;
        for (const double x : line) most = std::max(most, std::abs(x));
        return most;
    };
    f.pga = largest(motion.acceleration);
    f.pgv = largest(t.velocity);
    f.pgd = largest(t.displacement);
    if (motion.acceleration.empty()) return f;
    f.duration = motion.step * static_cast<double>(motion.acceleration.size() - 1);
    f.final_velocity = t.velocity.back();
    f.final_displacement = t.displacement.back();
    return f;
}

Trace integrated(const GroundMotion& motion)
{
    const std::vector<double>& a = motion.acceleration;
    const double h = motion.step;
    Trace t{std::vector<double>(a.size(), 0.0), std::vector<double>(a.size(), 0.0)};
    for (std::size_t i = 1; i < a.size(); ++i) {
        t.velocity[i] = t.velocity[i - 1] + 0.5 * h * (a[i - 1] + a[i]);
        t.displacement[i] =
            t.displacement[i - 1] + 0.5 * h * (t.velocity[i - 1] + t.velocity[i]);
    }
    return t;
}

std::string unfit_motion(const MotionFacts& facts, double most_final_velocity)
{
    if (facts.pga == 0.0) return "all accelerations are 0";
    const double share = std::abs(facts.final_velocity) / facts.pgv;
    if (share <= most_final_velocity) return {};
    char text[200];
    std::snprintf(text, sizeof text,
                  "the velocity ends at %.3g m/s, %.0f %% of the PGV (at most %.0f %%): the "
                  "record is cut off, has an offset "
                  "or a wrong time step; correct its baseline",
                  facts.final_velocity, 100.0 * share, 100.0 * most_final_velocity);
    return text;
}

void check_motion(const std::string& path, const GroundMotion& motion,
                  double most_final_velocity)
{
    if (const std::string why = unfit_motion(motion_facts(motion), most_final_velocity);
        !why.empty())
        throw RecordError(path, 0, why);
}

GroundMotion scaled(GroundMotion motion, double factor)
{
    for (double& a : motion.acceleration) a *= factor;
    return motion;
}

} // namespace ground
