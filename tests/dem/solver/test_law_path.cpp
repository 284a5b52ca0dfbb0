/// One contact that is moved by hand answers as the laws say: strengths, energies, closed
/// forms.

#include "dem/contact/closure.hpp"
#include "dem/solver/law_path.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

constexpr double kFt = 2.0e6, kC = 3.0e6, kG = 110.0, kTan = 0.7, kResidual = 0.6;

dem::CrackMaterial stone()
{
    dem::CrackMaterial c{};
    c.kn = 1e11;
    c.ks = 4e10;
    c.ft = kFt;
    c.cohesion = kC;
    c.tan_phi = kTan;
    c.tan_phi_res = kResidual;
    c.fracture_energy = kG;
    return c;
}

std::vector<dem::LawMove> moves_to(double u_n, double u_s, int steps = 20000)
{
    return std::vector<dem::LawMove>(static_cast<std::size_t>(steps),
                                     dem::LawMove{u_n / steps, u_s / steps});
}

/// Presses, then slips.
std::vector<dem::LawMove> slipped(double u_n, double u_s)
{
    std::vector<dem::LawMove> moves = moves_to(u_n, 0.0, 1);
    const std::vector<dem::LawMove> slip = moves_to(0.0, u_s);
    moves.insert(moves.end(), slip.begin(), slip.end());
    return moves;
}

double largest(const std::vector<dem::LawPoint>& path, double dem::LawPoint::*of)
{
    double most = 0.0;
    for (const dem::LawPoint& at : path) most = std::max(most, at.*of);
    return most;
}

/// Integral of sigma over the opening [J/m2].
double work(const std::vector<dem::LawPoint>& path)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
        sum += 0.5 * (path[i].sigma + path[i - 1].sigma) * (path[i].u_n - path[i - 1].u_n);
    return sum;
}

} // namespace

TEST_CASE("law path: a crack that is opened reaches f_t and costs G", "[dem][law_path]")
{
    const auto path = dem::crack_path(stone(), {}, moves_to(1.5 * 2.0 * kG / kFt, 0.0));
    CHECK(path.size() == 20001);
    CHECK(path.front().sigma == 0.0);
    CHECK(largest(path, &dem::LawPoint::sigma) == Approx(kFt).epsilon(1e-3));
    CHECK(work(path) == Approx(kG).epsilon(1e-4));
    CHECK(path.back().sigma == 0.0);
    CHECK(path.back().damage == 1.0);
}

TEST_CASE("law path: under pressure a crack holds c + p tan(phi), then friction",
          "[dem][law_path]")
{
    const double p = 1.5e6, slip = 3.0 * kC / stone().ks;
    for (const bool mixed : {false, true}) {
        dem::CrackMaterial c = stone();
        if (mixed) c.shear_fracture_energy = 1.5 * kC * kC / (2.0 * c.ks);
        const auto path = dem::crack_path(c, {.mixed_mode = mixed}, slipped(-p / c.kn, slip));
        CHECK(largest(path, &dem::LawPoint::tau) == Approx(kC + p * kTan).epsilon(1e-3));
        CHECK(path.back().tau == Approx(p * kResidual).epsilon(1e-9));
        CHECK(path.back().sigma == Approx(-p).epsilon(1e-9));
        CHECK(path.back().u_s == Approx(slip).epsilon(1e-9));
        const auto softens = std::ranges::count_if(
            path, [](const dem::LawPoint& at) { return at.damage > 0.0 && at.damage < 1.0; });
        CHECK((mixed ? softens > 1000 : softens == 0));
    }
}

TEST_CASE("law path: laws differ where a wall's laws differ", "[dem][law_path]")
{
    // Opened to the half of its strength, then slipped until it breaks, then opened.
    std::vector<dem::LawMove> moves = slipped(0.5 * kFt / stone().kn, 3.0 * kC / stone().ks);
    const auto opened = moves_to(0.4 * kFt / stone().kn, 0.0, 1);
    moves.insert(moves.end(), opened.begin(), opened.end());
    const double coupled = dem::crack_path(stone(), {}, moves).back().sigma;
    const double alone =
        dem::crack_path(stone(), {.law = dem::ContactLaw::uncoupled}, moves).back().sigma;
    CHECK(coupled == 0.0);
    CHECK(alone == Approx(0.9 * kFt).epsilon(1e-9));

    // Half of the softening, then closed: with unloading = elastic the crack stays propped.
    const double elastic = kFt / stone().kn, half = 0.5 * (elastic + 2.0 * kG / kFt);
    std::vector<dem::LawMove> closed = moves_to(half, 0.0);
    const auto back = moves_to(-half, 0.0);
    closed.insert(closed.end(), back.begin(), back.end());
    CHECK(std::abs(dem::crack_path(stone(), {}, closed).back().sigma) < 1.0);
    CHECK(
        dem::crack_path(stone(), {.unloading = dem::Unloading::elastic}, closed).back().sigma <
        -kFt);
}

TEST_CASE("law path: a dry joint closes as its law says and slides by Coulomb",
          "[dem][law_path]")
{
    dem::JointMaterial j{};
    j.kn = 8e9;
    j.ks = 3.3e9;
    j.tan_phi = 0.62;
    const double w = 6e-5;
    const auto linear = dem::joint_path(j, dem::Closure::linear, slipped(-w, 1e-3));
    CHECK(linear.back().sigma == Approx(-j.kn * w).epsilon(1e-12));
    CHECK(linear.back().tau == Approx(j.kn * w * j.tan_phi).epsilon(1e-12));

    j.closing = {.initial_stiffness = 4.87e9, .maximum = 1.54e-4, .stiffest = 1.2e11};
    const double x = w / j.closing.maximum;
    const double rise = j.closing.initial_stiffness * j.closing.maximum;
    CHECK(dem::joint_path(j, dem::Closure::hyperbolic, moves_to(-w, 0.0)).back().sigma ==
          Approx(-rise * x / (1.0 - x)).epsilon(1e-9));
    CHECK(dem::joint_path(j, dem::Closure::exponential, moves_to(-w, 0.0)).back().sigma ==
          Approx(-rise * std::expm1(x)).epsilon(1e-9));
    CHECK(dem::joint_path(j, dem::Closure::exponential, moves_to(w, 0.0)).back().sigma == 0.0);

    // A joint that loses energy unloads below its loading.
    const auto work_of_cycle = [&](double loss) {
        j.closing.loss = loss;
        std::vector<dem::LawMove> cycle = moves_to(-w, 0.0);
        const auto back = moves_to(w, 0.0);
        cycle.insert(cycle.end(), back.begin(), back.end());
        return work(dem::joint_path(j, dem::Closure::exponential, cycle));
    };
    CHECK(std::abs(work_of_cycle(0.0)) < 1e-6);
    CHECK(work_of_cycle(0.3) > 0.2 * 0.5 * rise * x * w);
}
