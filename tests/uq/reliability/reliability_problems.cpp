#include "tests/uq/reliability/reliability_problems.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace problems {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::sqrt2;

struct Moments {
    double mean, sd;
};

/// Independent variables: normal where `log` is false, lognormal where true.
uq::Map independent(std::vector<Moments> m, std::vector<bool> log)
{
    return [m, log](const MatrixXd& u) {
        MatrixXd x = u;
        for (Eigen::Index j = 0; j < u.cols(); ++j) {
            const auto [mean, sd] = m[static_cast<std::size_t>(j)];
            const double s = std::sqrt(std::log1p(sd * sd / (mean * mean)));
            if (log[static_cast<std::size_t>(j)])
                x.col(j) = (std::log(mean) - 0.5 * s * s + s * u.col(j).array()).exp();
            else
                x.col(j) = mean + sd * u.col(j).array();
        }
        return x;
    };
}

Problem difference(std::string name, double resistance, double exact)
{
    return {std::move(name),
            limit_state(
                2, [](const VectorXd& x) { return x(0) - x(1); },
                independent({{resistance, 1.0}, {2.0, 1.0}}, {false, false})),
            exact, (resistance - 2.0) / sqrt2};
}

Problem frame(std::string name, double sd5, double sd6, double exact, double beta)
{
    return {std::move(name),
            limit_state(
                6,
                [](const VectorXd& x) {
                    return x(0) + 2 * x(1) + 2 * x(2) + x(3) - 5 * x(4) - 5 * x(5);
                },
                independent({{120, 12}, {120, 12}, {120, 12}, {120, 12}, {50, sd5}, {40, sd6}},
                            std::vector<bool>(6, true))),
            exact, beta};
}

} // namespace

uq::BlackBox by_rows(G f)
{
    return [f = std::move(f)](const uq::Samples& s) {
        uq::Responses r{MatrixXd(s.x.rows(), 1), std::vector<std::string>(s.id.size())};
        for (Eigen::Index i = 0; i < s.x.rows(); ++i) r.y(i, 0) = f(s.x.row(i).transpose());
        return r;
    };
}

std::size_t count_failed(const uq::Responses& r)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(r.failure, [](const std::string& why) { return !why.empty(); }));
}

uq::LimitState limit_state(Eigen::Index dimension, G g, uq::Map map)
{
    return {by_rows(std::move(g)), std::move(map), dimension};
}

Problem difference_4_2() { return difference("R - S 4/2", 4.0, 7.864960352514e-2); }
Problem difference_7_2() { return difference("R - S 7/2", 7.0, 2.034760087225e-4); }

Problem four_branch()
{
    return {
        "four-branch",
        limit_state(2,
                    [](const VectorXd& x) {
                        const double d = x(0) - x(1), s = (x(0) + x(1)) / sqrt2;
                        const double bow = 3.0 + 0.1 * d * d;
                        return std::min({bow - s, bow + s, d + 7.0 / sqrt2, -d + 7.0 / sqrt2});
                    }),
        2.222795066194e-3, 3.0};
}

Problem rp22()
{
    return {"RP22",
            limit_state(2,
                        [](const VectorXd& x) {
                            const double d = x(0) - x(1);
                            return 2.5 - (x(0) + x(1)) / sqrt2 + 0.1 * d * d;
                        }),
            4.207305511300e-3, 2.5};
}

Problem axial_beam()
{
    return {"axial beam",
            limit_state(
                2, [](const VectorXd& x) { return x(0) - x(1) / (100.0 * std::numbers::pi); },
                independent({{300, 30}, {75000, 5000}}, {true, false})),
            2.919819462483e-2, 1.88104652};
}

Problem rp8() { return frame("RP8", 10, 8, 7.897937333e-4, 3.21163954); }

Problem portal_frame() { return frame("portal frame", 15, 12, 1.220518322e-2, 2.3481657370); }

Problem steel_section()
{
    return {"steel section",
            limit_state(
                2, [](const VectorXd& x) { return x(0) * x(1) - 1140.0; },
                independent({{38, 3.8}, {54, 2.7}}, {true, false})),
            1.378219206e-7, 5.1507850307};
}

Problem log_ratio(double z)
{
    const double variance = std::log(1.25); // of ln x: cov 0.5
    const double s = std::sqrt(variance), rho = std::log(1.0 + 0.3 * 0.25) / variance;
    const uq::Map map = [=](const MatrixXd& u) {
        MatrixXd x(u.rows(), 2);
        x.col(0) = (s * u.col(0).array() - 0.5 * variance).exp();
        x.col(1) = (s * (rho * u.col(0) + std::sqrt(1.0 - rho * rho) * u.col(1)).array() -
                    0.5 * variance)
                       .exp();
        return x;
    };
    const double beta = -std::log(z) / (s * std::sqrt(2.0 * (1.0 - rho)));
    Problem p{"log ratio",
              limit_state(
                  2, [](const VectorXd& x) { return x(0) / x(1); }, map),
              gsl_cdf_ugaussian_Q(beta), beta};
    p.limit.threshold = z;
    return p;
}

std::vector<Problem> all()
{
    return {difference_4_2(), difference_7_2(), four_branch(), rp22(), axial_beam(), rp8(),
            portal_frame(),   steel_section(),  log_ratio(0.4)};
}

uq::LimitState two_sided(double radius)
{
    return limit_state(2, [=](const VectorXd& x) { return radius - std::abs(x(0)); });
}

uq::LimitState failing(uq::LimitState limit, std::function<bool(const VectorXd&)> fails)
{
    const uq::BlackBox sound = limit.model;
    limit.model = [sound, fails](const uq::Samples& s) {
        uq::Responses r = sound(s);
        for (Eigen::Index i = 0; i < s.x.rows(); ++i)
            if (fails(s.x.row(i).transpose()))
                r.failure[static_cast<std::size_t>(i)] = "no convergence";
        return r;
    };
    return limit;
}

} // namespace problems
