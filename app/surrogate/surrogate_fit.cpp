#include "app/surrogate/surrogate_fit.hpp"

#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "uq/estimates/two_heaps.hpp"
#include "uq/sensitivity/hsic.hpp"
#include "uq/sensitivity/rank_index.hpp"
#include "uq/surrogates/process_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>

namespace app {
namespace {

/// Whether the response varies by more than rounding.
bool varies(const Eigen::VectorXd& y)
{
    const double size = y.cwiseAbs().maxCoeff();
    return y.maxCoeff() - y.minCoeff() > 1e-9 * size;
}

SurrogateError error_of(const Eigen::VectorXd& residual, const Eigen::VectorXd& y)
{
    const double square = residual.squaredNorm() / static_cast<double>(y.size());
    return {1.0 - square / (y.array() - y.mean()).square().mean(), std::sqrt(square)};
}

/// Takes the process whose noise varies where that tells walls left out clearly better.
void let_noise_vary(LevelSurrogate& s)
{
    try {
        uq::GaussianProcess p =
            uq::fit_process({s.points.coordinates, s.points.y},
                            {.kernel = s.process->kernel, .noise_varies = true});
        if (!uq::noise_clearly_varies(p, *s.process)) return;
        s.process = std::move(p);
    } catch (const std::invalid_argument&) { // no factor: the noise is the same everywhere
    }
}

/// The kernel with the smaller error on walls left out, at parameters that have seen them.
/// @return what it says of walls that its parameters have not seen
uq::ProcessLeaveOneOut fit_processes(LevelSurrogate& s)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto kernel :
         {uq::ProcessKernel::matern_52, uq::ProcessKernel::squared_exponential})
        try {
            uq::GaussianProcess p =
                uq::fit_process({s.points.coordinates, s.points.y}, {.kernel = kernel});
            const double error = uq::leave_one_out(p).residual.squaredNorm();
            if (s.process && !(error < least)) continue;
            s.process = std::move(p);
            least = error;
        } catch (const std::invalid_argument&) { // no factor: the other kernel, or chaos alone
        }
    if (!s.process) return {};
    let_noise_vary(s);
    uq::ProcessLeaveOneOut out = uq::held_out(*s.process);
    s.process_error = error_of(out.residual, s.points.y);
    s.inflation = uq::inflation_of(out);
    return out;
}

void fit_both(LevelSurrogate& s, const std::vector<uq::PolynomialFamily>& families)
{
    const Eigen::VectorXd& y = s.points.y;
    const uq::ProcessLeaveOneOut process_out = fit_processes(s);
    s.chaos = uq::fit_chaos(families, s.points.coordinates, y);
    const Eigen::VectorXd out = uq::held_out_residuals(*s.chaos, s.points.coordinates, y);
    s.chaos_error = error_of(out, y);
    s.chaos_is_better = !s.process || s.chaos_error.q2 > s.process_error.q2;
    s.left_out = y - (s.chaos_is_better ? out : process_out.residual);
}

void judge(LevelSurrogate& s)
{
    const double q2 = s.chaos_is_better ? s.chaos_error.q2 : s.process_error.q2;
    const auto inputs = static_cast<std::size_t>(s.points.x.cols());
    const auto walls = s.points.sample.size();
    if (walls < kWallsPerInput * inputs)
        s.doubts.push_back(std::to_string(walls) + " walls are fewer than " +
                           std::to_string(kWallsPerInput) + " for each of " +
                           std::to_string(inputs) + " random inputs; run at least " +
                           std::to_string(kWallsPerInput * inputs) + ".");
    if (!(q2 >= kTrustedQ2))
        s.doubts.push_back(
            "The inputs explain less than half of the variance of walls left out (Q2 " +
            number(q2, 2) + "): the response jumps, or depends on something else.");
    if (s.one_heap && *s.one_heap < kOneHeapLevel && !(q2 >= kExplainedQ2))
        s.doubts.push_back("The response lies in two heaps or more (p of one heap " +
                           number(*s.one_heap, 2) + ") that the inputs do not tell apart (Q2 " +
                           number(q2, 2) + "): a mean between them is no wall's.");
}

/// Walls that outlast their push are left out: where they are many, an answer is that of the
/// others. Shares of the variance are still theirs.
void judge_bounds(LevelSurrogate& s)
{
    const auto bounds = static_cast<double>(s.points.bounds.size());
    const auto all = bounds + static_cast<double>(s.points.sample.size());
    if (!(s.chaos || s.process) || !(bounds > kMostBounds * all)) return;
    s.doubts.push_back(number(bounds, 6) + " of " + number(all, 6) +
                       " walls outlast the push and are left out: it holds for walls that do "
                       "not; push further.");
}

/// The estimate where it can be a result.
std::optional<uq::Estimate> as_result(const uq::Estimate& e)
{
    return e.value > 0.0 && e.value <= 1.0 ? std::optional(e) : std::nullopt;
}

void add_given_data(LevelSurrogate& s, std::uint64_t seed)
{
    for (Eigen::Index k = 0; k < s.points.x.cols(); ++k) {
        const auto stream = static_cast<std::uint64_t>(k);
        const Eigen::VectorXd x = s.points.coordinates.col(k);
        GivenData g;
        if (x.maxCoeff() > x.minCoeff()) {
            const uq::Hsic h =
                uq::hsic(x, s.points.y, {.seed = seed, .stream = 2 * stream + 1});
            const uq::Estimate rank =
                uq::rank_index(x, s.points.y, {.seed = seed, .stream = 2 * stream});
            g.p_value =
                std::min(1.0, 2.0 * std::min(h.p_value, uq::independence_p(rank, s.points.y)));
            if (g.p_value < kDependsLevel) {
                g.rank = as_result(rank);
                g.hsic = as_result(h.index);
            }
        }
        s.given.push_back(g);
    }
}

} // namespace

LevelSurrogate fit_surrogate(SurrogatePoints points,
                             const std::vector<uq::PolynomialFamily>& families, bool dependent,
                             std::uint64_t seed)
{
    LevelSurrogate s;
    s.points = std::move(points);
    const Eigen::Index n = s.points.y.size();
    if (n < static_cast<Eigen::Index>(kFewestSurrogateWalls))
        s.doubts.push_back("Only " +
                           counted(static_cast<std::size_t>(n), "wall has", "walls have") +
                           " the response; a surrogate needs at least " +
                           std::to_string(kFewestSurrogateWalls) + ".");
    else if (!varies(s.points.y))
        s.doubts.emplace_back(
            "The response is the same on all walls: there is nothing to learn.");
    else if (!s.points.no_coordinates.empty()) {
        s.doubts.push_back(s.points.no_coordinates);
        add_given_data(s, seed);
    } else {
        s.one_heap = uq::one_heap_p_value(
            std::span(s.points.y.data(), static_cast<std::size_t>(n)), 199, seed);
        fit_both(s, families);
        judge(s);
        add_given_data(s, seed);
    }
    if (!s.doubts.empty())
        s.no_indices = s.doubts.front();
    else if (dependent)
        s.no_indices =
            "The inputs depend on each other (uq.pearson, uq.together): shares of the variance "
            "are not defined.";
    else if (!(s.chaos_error.q2 >= kTrustedQ2))
        s.no_indices =
            "The chaos, which gives the indices, explains less than half of the variance.";
    judge_bounds(s);
    return s;
}

} // namespace app
