#include "dem/scene/closure_fit.hpp"

#include "dem/scene/paper_materials.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace {

/// Joint stiffnesses of the paper's walls through Eq. 2 (Table 3) [Pa/m], and their stresses
/// [Pa].
const std::vector<double> kStresses = {0.15e6, 0.50e6, 1.00e6, 1.25e6};
std::vector<double> stiffnesses()
{
    std::vector<double> kn;
    for (const double modulus : {566e6, 768e6, 1057e6, 1202e6})
        kn.push_back(dem::joint_stiffness(0.10, modulus, 15.5e9));
    return kn;
}

double sum_of_squares(const dem::Closing& c, const std::vector<double>& kn)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < kn.size(); ++i)
        sum += std::pow(dem::closed_stiffness(c, kStresses[i]) - kn[i], 2);
    return sum;
}

} // namespace

TEST_CASE("closure fit: one law explains the four wall moduli of the paper within 0.6 %",
          "[dem][closure_fit]")
{
    const dem::ClosureFit fit = dem::fit_closure(stiffnesses(), kStresses);
    CHECK(fit.initial_stiffness == Approx(4.866e9).epsilon(1e-4));
    CHECK(fit.maximum == Approx(0.1537e-3).epsilon(3e-4));
    const std::vector<double> residuals = {-0.0055, 0.0047, 0.0024, -0.0026};
    REQUIRE(fit.residuals.size() == residuals.size());
    for (std::size_t i = 0; i < residuals.size(); ++i)
        CHECK(fit.residuals[i] == Approx(residuals[i]).margin(5e-5));
}

TEST_CASE("closure fit: no law beside it has a smaller sum of squares", "[dem][closure_fit]")
{
    const std::vector<double> kn = stiffnesses();
    const dem::ClosureFit fit = dem::fit_closure(kn, kStresses);
    const dem::Closing best{.initial_stiffness = fit.initial_stiffness, .maximum = fit.maximum};
    const double least = sum_of_squares(best, kn);
    for (const double k : {0.999, 1.0, 1.001})
        for (const double v : {0.999, 1.0, 1.001}) {
            if (k == 1.0 && v == 1.0) continue;
            CHECK(sum_of_squares({.initial_stiffness = k * best.initial_stiffness,
                                  .maximum = v * best.maximum},
                                 kn) > least);
        }
}

TEST_CASE("closure fit: stiffnesses of a law give that law back, others none",
          "[dem][closure_fit]")
{
    const dem::Closing law{.initial_stiffness = 3e9, .maximum = 0.2e-3};
    const std::vector<double> two = {0.2e6, 0.9e6};
    const dem::ClosureFit fit = dem::fit_closure(
        std::vector{dem::closed_stiffness(law, two[0]), dem::closed_stiffness(law, two[1])},
        two);
    CHECK(fit.initial_stiffness == Approx(3e9).epsilon(1e-12));
    CHECK(fit.maximum == Approx(0.2e-3).epsilon(1e-12));
    CHECK(dem::fit_closure(std::vector{8e9, 6e9}, two).maximum < 0.0); // softer under more
    CHECK(dem::fit_closure(std::vector{1e9, 9e9}, two).initial_stiffness < 0.0);
}
