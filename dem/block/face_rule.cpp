#include "dem/block/face_rule.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace dem {

namespace {

struct Legendre {
    double p;  ///< P_n(x)
    double dp; ///< P_n'(x)
};

Legendre legendre(int n, double x)
{
    double p0 = 1.0, p1 = x;
    for (int k = 2; k <= n; ++k) {
        const double p2 = ((2 * k - 1) * x * p1 - (k - 1) * p0) / k;
        p0 = p1;
        p1 = p2;
    }
    return {p1, n * (p0 - x * p1) / (1.0 - x * x)};
}

/// Root of P_{n}'(x) near x, by Newton with P'' from Legendre's equation.
double interior_point(int n, double x)
{
    for (int i = 0; i < 50; ++i) {
        const auto [p, dp] = legendre(n, x);
        const double ddp = (2 * x * dp - n * (n + 1) * p) / (1.0 - x * x);
        const double step = dp / ddp;
        x -= step;
        if (std::abs(step) < 1e-15) break;
    }
    return x;
}

std::vector<double> lobatto_positions(int n)
{
    std::vector<double> x(n, 0.0);
    x.back() = 1.0;
    for (int i = 1; i < n - 1; ++i)
        x[i] = 0.5 * (1.0 + interior_point(n - 1, -std::cos(std::numbers::pi * i / (n - 1))));
    return x;
}

std::vector<double> even_positions(int n)
{
    std::vector<double> x(n);
    for (int i = 0; i < n; ++i) x[i] = static_cast<double>(i) / (n - 1);
    return x;
}

} // namespace

FacePoints face_points(FaceRule rule, int n, int zones_per_interval)
{
    assert(n >= 2 && zones_per_interval >= 1);
    FacePoints f;
    f.position = rule == FaceRule::even ? even_positions(n) : lobatto_positions(n);
    f.weight.assign(n, 0.0);
    const std::vector<double> nodes = edge_nodes(f, zones_per_interval);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const double before = k > 0 ? nodes[k] - nodes[k - 1] : 0.0;
        const double after = k + 1 < nodes.size() ? nodes[k + 1] - nodes[k] : 0.0;
        const std::vector<double> shape = edge_shapes(rule, f, nodes[k]);
        for (int i = 0; i < n; ++i) f.weight[i] += 0.5 * (before + after) * shape[i];
    }
    return f;
}

std::vector<double> edge_nodes(const FacePoints& points, int zones_per_interval)
{
    std::vector<double> nodes{points.position.front()};
    for (std::size_t i = 0; i + 1 < points.position.size(); ++i) {
        const double a = points.position[i], b = points.position[i + 1];
        for (int k = 1; k < zones_per_interval; ++k)
            nodes.push_back(a + (b - a) * k / zones_per_interval);
        nodes.push_back(b);
    }
    return nodes;
}

std::vector<double> edge_shapes(FaceRule rule, const FacePoints& points, double s)
{
    const auto& x = points.position;
    const std::size_t n = x.size();
    std::vector<double> shape(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        if (rule == FaceRule::even) {
            const double left = i > 0 ? (s - x[i - 1]) / (x[i] - x[i - 1]) : 1.0;
            const double right = i + 1 < n ? (x[i + 1] - s) / (x[i + 1] - x[i]) : 1.0;
            shape[i] = std::max(0.0, std::min(left, right));
        } else {
            shape[i] = 1.0;
            for (std::size_t j = 0; j < n; ++j)
                if (j != i) shape[i] *= (s - x[j]) / (x[i] - x[j]);
        }
    }
    return shape;
}

} // namespace dem
