#include "uq/sensitivity/delta_index.hpp"

#include "core/moments.hpp"
#include "uq/designs/stream.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace uq {

namespace {

constexpr int kGrid = 100;       // points at which densities are compared
constexpr double kBeyond = 3.0;  // widths of the kernel beyond the data
constexpr double kFarAway = 8.0; // widths beyond which a kernel is 0 to 1e-14

/// Number of classes (Plischke, Borgonovo, Smith 2013, section 5).
int delta_classes(Eigen::Index samples)
{
    const auto n = static_cast<double>(samples);
    const double exponent = 2.0 / (7.0 + std::tanh((1500.0 - n) / 500.0));
    return static_cast<int>(std::clamp(std::ceil(std::pow(n, exponent)), 2.0, 48.0));
}

double kernel_width(const Eigen::VectorXd& y)
{
    const auto n = static_cast<double>(y.size());
    const double sd = std::sqrt((y.array() - y.mean()).square().sum() / std::max(1.0, n - 1.0));
    return sd * std::pow(0.75 * n, -0.2);
}

Eigen::VectorXd density(const Eigen::VectorXd& y, double width, double from, double step)
{
    Eigen::VectorXd f = Eigen::VectorXd::Zero(kGrid);
    for (const double v : y)
        for (int g = 0; g < kGrid; ++g) {
            const double z = (from + step * g - v) / width;
            if (std::abs(z) < kFarAway) f(g) += std::exp(-0.5 * z * z);
        }
    return f / (width * std::sqrt(2.0 * std::numbers::pi) * static_cast<double>(y.size()));
}

bool delta_varies(const Eigen::VectorXd& v) { return v.maxCoeff() > v.minCoeff(); }

} // namespace

double raw_delta(const Eigen::VectorXd& x, const Eigen::VectorXd& y)
{
    const Eigen::Index n = y.size();
    if (!delta_varies(y)) return 0.0;
    std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](Eigen::Index i) { return x(i); });
    const double all_width = kernel_width(y);
    const double from = y.minCoeff() - kBeyond * all_width;
    const double step = (y.maxCoeff() + kBeyond * all_width - from) / (kGrid - 1);
    const Eigen::VectorXd f = density(y, all_width, from, step);
    const int classes = delta_classes(n);
    double delta = 0.0;
    for (int m = 0; m < classes; ++m) {
        const Eigen::Index begin = n * m / classes, end = n * (m + 1) / classes;
        const std::vector<Eigen::Index> members(order.begin() + begin, order.begin() + end);
        const Eigen::VectorXd part = y(members);
        // a class that does not vary is as narrow as the grid can show
        const double width = std::max(kernel_width(part), step);
        const double shift = step * (f - density(part, width, from, step)).cwiseAbs().sum();
        delta += 0.5 * std::min(shift, 2.0) * static_cast<double>(end - begin) /
                 static_cast<double>(n);
    }
    return delta;
}

Estimate delta_index(const Eigen::VectorXd& x, const Eigen::VectorXd& y, const DeltaOptions& o)
{
    if (x.size() != y.size() || y.size() < 10 || !x.allFinite() || !y.allFinite())
        throw std::invalid_argument(
            "delta: x and y must be finite, of equal length, at least 10");
    if (!delta_varies(x) || !delta_varies(y))
        throw std::invalid_argument("delta: x and y must vary");
    if (o.resamples < 10 || !(o.confidence > 0.0 && o.confidence < 1.0))
        throw std::invalid_argument("delta: at least 10 resamples, confidence in (0, 1)");
    const double raw = raw_delta(x, y);
    Stream draw(o.seed, o.stream, Purpose::bootstrap);
    std::vector<double> again;
    for (int b = 0; b < o.resamples; ++b) {
        std::vector<Eigen::Index> rows(static_cast<std::size_t>(y.size()));
        for (Eigen::Index& i : rows)
            i = static_cast<Eigen::Index>(draw.below(static_cast<std::uint64_t>(y.size())));
        again.push_back(raw_delta(x(rows), y(rows)));
    }
    const core::Moments m = core::moments(again);
    std::ranges::sort(again);
    const auto at = [&](double p) {
        const auto last = static_cast<double>(again.size() - 1);
        return 2.0 * raw - again[static_cast<std::size_t>(std::lround(p * last))];
    };
    const double tail = 0.5 * (1.0 - o.confidence);
    return {.value = 2.0 * raw - m.mean,
            .std_error = m.sd,
            .n = static_cast<std::size_t>(y.size()),
            .interval = {std::clamp(at(1.0 - tail), 0.0, 1.0), std::clamp(at(tail), 0.0, 1.0),
                         o.confidence}};
}

} // namespace uq
