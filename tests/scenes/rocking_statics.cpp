#include "tests/scenes/rocking_statics.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace scenes {

namespace {

constexpr double kStep = 5e-6; // of the drive [m]

using Eigen::Vector3d; // slip u and lift w of the middle of the base [m], rotation [-]

class Balance {
  public:
    explicit Balance(const RockingBlock& b) : b_(b), tau_(b.x.size(), 0.0)
    {
        double area = 0.0;
        for (const double a : b.area) area += a;
        at_ = {0.0, -b.load / (b.kn * area), 0.0};
    }

    void step(double drive)
    {
        Vector3d z = at_;
        Vector3d missing = residual(z, drive);
        for (int i = 0; i < 100 && largest(missing) > 1e-11; ++i) {
            const Vector3d way = jacobian(z, drive, missing).partialPivLu().solve(missing);
            double share = 1.0; // of Newton's step; the laws have corners
            while (share > 1e-6 &&
                   largest(residual(z - share * way, drive)) >= largest(missing))
                share *= 0.5;
            z -= share * way;
            missing = residual(z, drive);
        }
        if (!(largest(missing) < 1e-8)) throw std::runtime_error("the block has no balance");
        take(z);
    }
    [[nodiscard]] double force() const { return force_; }
    [[nodiscard]] double friction() const { return friction_; }

  private:
    static double largest(const Vector3d& v) { return v.lpNorm<Eigen::Infinity>(); }

    [[nodiscard]] double sigma(const Vector3d& z, std::size_t i) const
    {
        return std::min(0.0, b_.kn * (z[1] - b_.x[i] * z[2]));
    }
    [[nodiscard]] double tau(const Vector3d& z, std::size_t i) const
    {
        const double limit = -b_.tan_phi * sigma(z, i);
        return std::clamp(tau_[i] + b_.ks * (z[0] - at_[0]), -limit, limit);
    }

    /// In shares of the load, of its moment, and of a step.
    [[nodiscard]] Vector3d residual(const Vector3d& z, double drive) const
    {
        double vertical = b_.load, moment = 0.0, shear = 0.0;
        for (std::size_t i = 0; i < tau_.size(); ++i) {
            vertical += sigma(z, i) * b_.area[i];
            moment += sigma(z, i) * b_.area[i] * b_.x[i];
            shear += tau(z, i) * b_.area[i];
        }
        const double at_drive = z[0] + b_.height * z[2] + b_.drive_compliance * shear;
        return {vertical / b_.load, (moment + shear * b_.height) / (b_.load * b_.height),
                (drive - at_drive) / kStep};
    }
    [[nodiscard]] Eigen::Matrix3d jacobian(const Vector3d& z, double drive,
                                           const Vector3d& here) const
    {
        constexpr double kDelta = 1e-11; // [m], [-]
        Eigen::Matrix3d j;
        for (int k = 0; k < 3; ++k) {
            Vector3d beside = z;
            beside[k] += kDelta;
            j.col(k) = (residual(beside, drive) - here) / kDelta;
        }
        return j;
    }

    void take(const Vector3d& z)
    {
        std::vector<double> now(tau_.size());
        force_ = 0.0;
        for (std::size_t i = 0; i < tau_.size(); ++i) {
            now[i] = tau(z, i);
            const double slip = z[0] - at_[0] - (now[i] - tau_[i]) / b_.ks;
            friction_ += b_.area[i] * now[i] * slip;
            force_ += b_.area[i] * now[i];
        }
        tau_ = now;
        at_ = z;
    }

    const RockingBlock& b_;
    std::vector<double> tau_;
    Vector3d at_;
    double force_ = 0.0, friction_ = 0.0;
};

} // namespace

RockingBlock in_balance(const Scene& s, const dem::WallMaterials& materials,
                        const dem::Snapshot& pushed)
{
    const double l = s.wall.length, t = s.wall.thickness, h = s.beam.height;
    RockingBlock b;
    for (const dem::FaceState& face : pushed.faces) {
        if (face.kind != dem::FaceKind::base_joint) continue;
        for (const dem::ContactState& c : face.contacts) {
            b.x.push_back(c.at.x - 0.5 * l);
            b.area.push_back(c.area);
        }
    }
    b.kn = materials.base_joint.kn;
    b.ks = materials.base_joint.ks;
    b.tan_phi = materials.base_joint.tan_phi;
    b.load = (s.loads.vertical_stress + s.stone.density * 9.81 * s.wall.course_height) * l * t;
    b.height = s.loads.height;
    // Shear of the joint below the beam, and the turn of the beam on it.
    b.drive_compliance = 1.0 / (b.ks * l * t) + 12.0 * h * h / (b.kn * t * l * l * l);
    return b;
}

RockingLoop rocking_loop(const RockingBlock& block, double amplitude)
{
    Balance balance(block);
    RockingLoop loop;
    double drive = 0.0;
    const auto way = [&](double to, bool counts) {
        const int steps = static_cast<int>(std::lround(std::abs(to - drive) / kStep));
        const double from = drive;
        for (int k = 1; k <= steps; ++k) {
            const double force = balance.force(), friction = balance.friction();
            const double next = from + (to - from) * k / steps;
            balance.step(next);
            if (counts) {
                loop.energy += 0.5 * (force + balance.force()) * (next - drive);
                loop.friction += balance.friction() - friction;
                loop.force = std::max(loop.force, balance.force());
            }
            drive = next;
        }
    };
    for (const bool second : {false, true})
        for (const double to : {amplitude, -amplitude, 0.0}) way(to, second);
    return loop;
}

} // namespace scenes
