#include "fragility/intensity/sufficiency.hpp"
#include "uq/designs/stream.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace {

using namespace fragility;

/// Histories of some walls under each record at five intensities, with what records share.
struct Shaken {
    std::vector<CloudPoint> points;
    std::vector<double> feature;
    std::vector<std::size_t> record;
};

/// @param effect of the feature on ln response; if bounded, responses above 1.5 are known to
/// lie there
/// @param along how far ln intensity goes along with the feature
Shaken shaken(std::size_t records, double effect, std::uint32_t seed, bool bounded = false,
              double along = 0.0)
{
    Shaken s;
    uq::Stream random(seed, 0, uq::Purpose::monte_carlo);
    for (std::size_t r = 0; r < records; ++r) {
        const double feature = random.normal(), of_record = 0.3 * random.normal();
        for (int wall = 0; wall < 3; ++wall)
            for (const double scaled : {0.1, 0.2, 0.3, 0.5, 0.8}) {
                const double x = scaled * std::exp(along * feature);
                const double y = std::exp(1.0 + 1.2 * std::log(x) + effect * feature +
                                          of_record + 0.2 * random.normal());
                const bool above = bounded && y > 1.5;
                s.points.push_back({x, above ? right_censored(1.5) : observed(y), above});
                s.feature.push_back(feature);
                s.record.push_back(r);
            }
    }
    return s;
}

SufficiencyTest test_of(const Shaken& s)
{
    return test_sufficiency(s.points, fit_cloud(s.points), s.feature, s.record);
}

} // namespace

TEST_CASE("sufficiency: a feature that matters is found, with and without bounds",
          "[fragility][sufficiency]")
{
    CHECK(test_of(shaken(20, 0.5, 1)).p < 0.01);
    CHECK(test_of(shaken(20, 0.5, 1, true)).p < 0.01);
    CHECK(test_of(shaken(20, 0.0, 1)).p > 0.05);
}

TEST_CASE("sufficiency: the p-value of eight records by hand", "[fragility][sufficiency]")
{
    // Two intensities; the feature is orthogonal to the line, so that nothing is taken off it.
    constexpr double kUp[] = {0.1, -0.2, 0.3, -0.1, -0.3, 0.2, -0.1, 0.1};
    Shaken s;
    for (std::size_t i = 0; i < 8; ++i) {
        s.points.push_back({std::exp(static_cast<double>(i % 2)), observed(std::exp(kUp[i]))});
        s.feature.push_back(i < 4 ? 1.0 : -1.0);
        s.record.push_back(i);
    }
    // The line goes through both means, 0: scores are +-kUp, their sum is 0.2, of squares 0.30.
    const double t = 0.2 * std::sqrt(6.0 / (8.0 * 0.30 - 0.04));
    // Student's law with six degrees of freedom, in closed form
    const double c = 6.0 / (6.0 + t * t), root = std::sqrt(1.0 - c);
    CHECK(test_of(s).p == Approx(1.0 - root * (1.0 + 0.5 * c + 0.375 * c * c)).epsilon(1e-9));
}

TEST_CASE("sufficiency: histories of one record are no further records",
          "[fragility][sufficiency]")
{
    Shaken s = shaken(10, 0.0, 4);
    const double p = test_of(s).p;
    const Shaken once = s;
    for (std::size_t i = 0; i < once.points.size(); ++i) {
        s.points.push_back(once.points[i]);
        s.feature.push_back(once.feature[i]);
        s.record.push_back(once.record[i]);
    }
    CHECK(test_of(s).p == Approx(p).epsilon(1e-9));
}

TEST_CASE("sufficiency: where nothing can be said there is a reason",
          "[fragility][sufficiency]")
{
    CHECK(test_of(shaken(7, 0.5, 1)).reason == "fewer than 8 records");
    Shaken s = shaken(10, 0.5, 1);
    for (std::size_t i = 0; i < s.points.size(); ++i)
        s.feature[i] = 2.0 * std::log(s.points[i].intensity);
    CHECK(test_of(s).reason == "the feature is the measure itself");
    s.feature.pop_back();
    CHECK_THROWS_AS(test_of(s), std::invalid_argument);
}

TEST_CASE("sufficiency: of features that do not matter one in twenty is rejected at 5 %",
          "[fragility][sufficiency][repeats]")
{
    constexpr int kRuns = 2000;
    const auto rejected = [](std::size_t records, double along) {
        int n = 0;
        for (std::uint32_t seed = 1; seed <= kRuns; ++seed)
            n += test_of(shaken(records, 0.0, seed, true, along)).p < 0.05 ? 1 : 0;
        return n / static_cast<double>(kRuns);
    };
    for (const std::size_t records : {8, 20}) {
        INFO(records << " records");
        CHECK(rejected(records, 0.0) == Approx(0.04).margin(0.025));
        CHECK(rejected(records, 1.0) ==
              Approx(0.06).margin(0.045)); // the feature is known by x
    }
}
