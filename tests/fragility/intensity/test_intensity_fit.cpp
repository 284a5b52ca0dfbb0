#include "core/interval.hpp"
#include "fragility/intensity/intensity_fit.hpp"
#include "fragility/modes/ordinal_fit.hpp"
#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace {

using namespace fragility;

constexpr double kThreshold = 0.01, kLeast = 1e-4;

/// Capacities of `walls` under `records`; the drift is the threshold at the capacity, and walls
/// fall at `falls` times it.
std::vector<ShakenWallPoint> crossed(std::size_t walls, std::size_t records, double falls,
                                     double slope = 1.0)
{
    std::vector<ShakenWallPoint> all;
    for (std::size_t w = 0; w < walls; ++w)
        for (std::size_t r = 0; r < records; ++r) {
            const double u = uniform(fit_data::bits(7, 3 * r)),
                         v = uniform(fit_data::bits(8, 3 * w)),
                         e = uniform(fit_data::bits(9, 100 * w + r));
            const double capacity = 0.4 * std::exp(0.8 * (u - 0.5) + 0.5 * (v - 0.5) + 0.2 * e);
            for (const double x : {0.1, 0.2, 0.3, 0.4, 0.6, 0.9, 1.4}) {
                const bool fell = x > falls * capacity;
                const double seen = std::min(x, falls * capacity) / capacity;
                all.push_back({w, r, x, kThreshold * std::pow(seen, slope), fell});
            }
        }
    return all;
}

} // namespace

TEST_CASE("intensity fit: stripes are the fit of counts", "[fragility][intensity]")
{
    const auto points = crossed(4, 6, 3.0);
    std::vector<StateCounts> counts;
    for (const double x : {0.1, 0.2, 0.3, 0.4, 0.6, 0.9, 1.4}) {
        StateCounts c{x, {0.0, 0.0}};
        for (const ShakenWallPoint& p : points)
            if (p.intensity == x) c.walls[p.fell || p.response > kThreshold ? 1 : 0] += 1.0;
        counts.push_back(c);
    }
    const OrdinalFit reference = fit_ordinal(counts);
    REQUIRE(reference.outcome == ModelOutcome::converged);
    const IntensityFit f = fit_intensity(IntensityMethod::stripes, points, kThreshold, kLeast);
    REQUIRE(f.outcome == ModelOutcome::converged);
    CHECK(f.curve.median == Approx(reference.medians[0]).epsilon(1e-7));
    CHECK(f.curve.dispersion == Approx(reference.dispersion).epsilon(1e-7));
    CHECK(f.n == 4 * 6 * 7);
}

TEST_CASE(
    "intensity fit: the errors of an IDA without bounds are those of record and wall means",
    "[fragility][intensity]")
{
    constexpr std::size_t kWalls = 4, kRecords = 7;
    const auto points = crossed(kWalls, kRecords, 100.0);
    Eigen::MatrixXd y(kRecords, kWalls);
    for (const PairCapacity& c : pair_capacities(points, kThreshold)) {
        REQUIRE(c.capacity.lower == c.capacity.upper);
        y(static_cast<Eigen::Index>(c.record), static_cast<Eigen::Index>(c.wall)) =
            std::log(c.capacity.lower);
    }
    const auto error = [](const Eigen::VectorXd& means) {
        const auto n = static_cast<double>(means.size());
        return std::sqrt((means.array() - means.mean()).square().sum() / (n * (n - 1.0)));
    };
    const ClusteredFit c = fit_clustered(IntensityMethod::ida, points, kThreshold, kLeast);
    REQUIRE(c.reason.empty());
    CHECK(c.crossed);
    CHECK(c.fit.curve.median == Approx(std::exp(y.mean())).epsilon(1e-7));
    CHECK(c.record_error == Approx(error(y.rowwise().mean())).epsilon(1e-5));
    CHECK(c.wall_error == Approx(error(y.colwise().mean().transpose())).epsilon(1e-5));
    const double half = std::log(c.median.upper / c.fit.curve.median);
    CHECK(half > 2.0 * std::hypot(c.record_error, c.wall_error));
    CHECK(std::log(c.fit.curve.median / c.median.lower) == Approx(half));
}

TEST_CASE("intensity fit: a cloud finds the line through walls that fell",
          "[fragility][intensity]")
{
    // Without scatter but that of the walls the median is that of the capacities.
    const auto points = crossed(6, 9, 1.5, 2.0);
    const IntensityFit cloud =
                           fit_intensity(IntensityMethod::cloud, points, kThreshold, kLeast),
                       ida = fit_intensity(IntensityMethod::ida, points, kThreshold, kLeast);
    REQUIRE(cloud.outcome == ModelOutcome::converged);
    CHECK(cloud.curve.median == Approx(ida.curve.median).epsilon(0.03));
    CHECK(cloud.curve.dispersion == Approx(ida.curve.dispersion).epsilon(0.1));
}

TEST_CASE("intensity fit: walls that have one record each are part of their records",
          "[fragility][intensity]")
{
    std::vector<ShakenWallPoint> paired;
    for (const ShakenWallPoint& p : crossed(12, 12, 3.0))
        if (p.wall == p.record) paired.push_back(p);
    const ClusteredFit c = fit_clustered(IntensityMethod::stripes, paired, kThreshold, kLeast);
    REQUIRE(c.reason.empty());
    CHECK_FALSE(c.crossed);
    CHECK(c.record_error > 0.0);
    CHECK(c.wall_error == 0.0);
}

TEST_CASE("intensity fit: what no history reaches has no curve and says so",
          "[fragility][intensity]")
{
    const auto points = crossed(3, 4, 100.0);
    const ClusteredFit c =
        fit_clustered(IntensityMethod::stripes, points, core::kInfinity, kLeast);
    CHECK(c.fit.outcome != ModelOutcome::converged);
    CHECK(c.reason == "no history reaches it");
    CHECK(c.median.lower == 0.0);
    CHECK(std::isinf(c.median.upper));
}

TEST_CASE("intensity fit: stripes that differ at one intensity or at none say which it is",
          "[fragility][intensity]")
{
    std::vector<ShakenWallPoint> points;
    for (std::size_t r = 0; r < 4; ++r)
        for (const double x : {0.1, 0.2, 0.4})
            points.push_back({0, r, x, x > 0.3 ? 2.0 * kThreshold : 0.0, false});
    const auto reason = [&] {
        return fit_intensity(IntensityMethod::stripes, points, kThreshold, kLeast).reason;
    };
    CHECK(reason() == "the intensity tells without error which histories reach it");
    points[1].response = 2.0 * kThreshold; // one of four at 0.2
    CHECK(reason() == "histories differ at a single intensity; add intensities near it");
}
