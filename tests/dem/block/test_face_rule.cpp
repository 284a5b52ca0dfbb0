#include "dem/block/face_rule.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace {

using dem::FacePoints;
using dem::FaceRule;

/// Integral over [0, 1] of a function by its values at the points.
template <class F> double integral(const FacePoints& f, F&& function)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < f.position.size(); ++i)
        sum += f.weight[i] * function(f.position[i]);
    return sum;
}

double legendre(int n, double x)
{
    double before = 1.0, p = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
    }
    return n == 0 ? 1.0 : p;
}

/// Gauss-Lobatto weights on [0, 1]: 1/(n (n - 1) P_{n-1}(x)^2), x in [-1, 1].
std::vector<double> lobatto_weights(const FacePoints& f)
{
    const int n = static_cast<int>(f.position.size());
    std::vector<double> w;
    for (const double s : f.position)
        w.push_back(1.0 / (n * (n - 1) * std::pow(legendre(n - 1, 2 * s - 1), 2)));
    return w;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b)
{
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

} // namespace

TEST_CASE(
    "face rule: points run from end to end, symmetric, with positive weights that sum to 1",
    "[dem][face_rule]")
{
    const FaceRule rule = GENERATE(FaceRule::even, FaceRule::lobatto);
    const int n = GENERATE(range(2, 13)), zones = GENERATE(1, 2, 3, 7);
    const FacePoints f = dem::face_points(rule, n, zones);
    REQUIRE(static_cast<int>(f.position.size()) == n);
    REQUIRE(static_cast<int>(f.weight.size()) == n);
    CHECK(f.position.front() == 0.0);
    CHECK(f.position.back() == 1.0);
    for (int i = 0; i < n; ++i) {
        if (i > 0) CHECK(f.position[i] > f.position[i - 1]);
        CHECK(f.position[i] + f.position[n - 1 - i] == Approx(1.0).epsilon(1e-14));
        CHECK(f.weight[i] == Approx(f.weight[n - 1 - i]).epsilon(1e-12));
        CHECK(f.weight[i] > 0.0);
    }
    CHECK(integral(f, [](double) { return 1.0; }) == Approx(1.0).epsilon(1e-13));
    CHECK(integral(f, [](double s) { return s; }) == Approx(0.5).epsilon(1e-13));
}

TEST_CASE("face rule: even points have the trapezoid weights, whatever the zones",
          "[dem][face_rule]")
{
    const int n = GENERATE(2, 3, 4, 9), zones = GENERATE(1, 2, 5);
    const FacePoints f = dem::face_points(FaceRule::even, n, zones);
    for (int i = 0; i < n; ++i) {
        const bool end = i == 0 || i == n - 1;
        CHECK(f.position[i] == Approx(static_cast<double>(i) / (n - 1)).epsilon(1e-15));
        CHECK(f.weight[i] == Approx((end ? 0.5 : 1.0) / (n - 1)).epsilon(1e-13));
    }
}

TEST_CASE("face rule: lobatto points are those of Gauss and Lobatto", "[dem][face_rule]")
{
    // With the weights of the rule they integrate polynomials up to degree 2 n - 3; no other
    // points do.
    const int n = GENERATE(range(2, 13));
    FacePoints f = dem::face_points(FaceRule::lobatto, n, 1);
    f.weight = lobatto_weights(f);
    for (int degree = 0; degree <= 2 * n - 3; ++degree)
        CHECK(integral(f, [degree](double s) { return std::pow(s, degree); }) ==
              Approx(1.0 / (degree + 1)).epsilon(1e-13));
}

TEST_CASE("face rule: lobatto weights tend to those of the rule as the zones get finer, at "
          "second order",
          "[dem][face_rule]")
{
    const int n = GENERATE(3, 4, 5, 8);
    const auto error = [n](int zones) {
        const FacePoints f = dem::face_points(FaceRule::lobatto, n, zones);
        return largest_difference(f.weight, lobatto_weights(f));
    };
    CHECK(error(64) < 1e-3 / n);
    CHECK(error(128) / error(64) == Approx(0.25).epsilon(0.01));
}

TEST_CASE("face rule: a weight is the integral of its shape along the edge of the zones",
          "[dem][face_rule]")
{
    const FaceRule rule = GENERATE(FaceRule::even, FaceRule::lobatto);
    const int n = GENERATE(2, 4, 7), zones = GENERATE(1, 2, 5);
    const FacePoints f = dem::face_points(rule, n, zones);
    const std::vector<double> nodes = dem::edge_nodes(f, zones);
    std::vector<double> area(n, 0.0);
    for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
        const auto a = dem::edge_shapes(rule, f, nodes[k]),
                   b = dem::edge_shapes(rule, f, nodes[k + 1]);
        for (int i = 0; i < n; ++i) area[i] += 0.5 * (nodes[k + 1] - nodes[k]) * (a[i] + b[i]);
    }
    CHECK(largest_difference(area, f.weight) < 1e-14);
}

TEST_CASE("face rule: edge nodes divide each interval between points evenly",
          "[dem][face_rule]")
{
    const FaceRule rule = GENERATE(FaceRule::even, FaceRule::lobatto);
    const int n = GENERATE(2, 5), zones = GENERATE(1, 3);
    const FacePoints f = dem::face_points(rule, n, zones);
    const std::vector<double> nodes = dem::edge_nodes(f, zones);
    REQUIRE(static_cast<int>(nodes.size()) == (n - 1) * zones + 1);
    for (int i = 0; i < n; ++i) CHECK(nodes[i * zones] == f.position[i]);
    for (int i = 0; i + 1 < n; ++i)
        for (int k = 0; k < zones; ++k)
            CHECK(nodes[i * zones + k + 1] - nodes[i * zones + k] ==
                  Approx((f.position[i + 1] - f.position[i]) / zones).epsilon(1e-13));
}

TEST_CASE("face rule: shapes are 1 at their point, 0 at the others, and carry linear functions "
          "anywhere",
          "[dem][face_rule]")
{
    const FaceRule rule = GENERATE(FaceRule::even, FaceRule::lobatto);
    const int n = GENERATE(range(2, 13));
    const FacePoints f = dem::face_points(rule, n, 2);
    for (int i = 0; i < n; ++i) {
        const std::vector<double> shape = dem::edge_shapes(rule, f, f.position[i]);
        for (int j = 0; j < n; ++j) CHECK(shape[j] == (i == j ? 1.0 : 0.0));
    }
    for (const double s : {0.0, 0.013, 0.31, 0.5, 0.77, 0.999, 1.0}) {
        const std::vector<double> shape = dem::edge_shapes(rule, f, s);
        CHECK(std::accumulate(shape.begin(), shape.end(), 0.0) == Approx(1.0).epsilon(1e-12));
        double line = 0.0;
        for (int i = 0; i < n; ++i) line += shape[i] * (3.0 - 2.0 * f.position[i]);
        CHECK(line == Approx(3.0 - 2.0 * s).epsilon(1e-12));
    }
}

TEST_CASE("face rule: the edge bends as a polynomial with lobatto points, in straight pieces "
          "with even ones",
          "[dem][face_rule]")
{
    const int n = 5;
    const FacePoints lobatto = dem::face_points(FaceRule::lobatto, n, 1),
                     even = dem::face_points(FaceRule::even, n, 1);
    const auto quartic = [](double s) { return s * s * s * s - s; };
    for (const double s : {0.05, 0.4, 0.83}) {
        const auto l = dem::edge_shapes(FaceRule::lobatto, lobatto, s),
                   e = dem::edge_shapes(FaceRule::even, even, s);
        double smooth = 0.0, pieces = 0.0;
        for (int i = 0; i < n; ++i) {
            smooth += l[i] * quartic(lobatto.position[i]);
            pieces += e[i] * quartic(even.position[i]);
        }
        CHECK(smooth == Approx(quartic(s)).epsilon(1e-12));
        const double a = std::floor(4 * s) / 4, b = a + 0.25; // neighbours
        CHECK(pieces ==
              Approx((quartic(a) * (b - s) + quartic(b) * (s - a)) / (b - a)).epsilon(1e-12));
    }
}
