#include "app/calibration/calibration_surrogate.hpp"

#include "uq/surrogates/process_fit.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace app {
namespace {

bool is_constant(const Eigen::VectorXd& y) { return y.maxCoeff() - y.minCoeff() < 1e-9; }

double mean_square(const uq::ProcessLeaveOneOut& out)
{
    return out.residual.squaredNorm() / static_cast<double>(out.residual.size());
}

/// The surrogate with this process, and what processes like it are worth on walls that neither
/// they nor their parameters have seen.
AnswerSurrogate judged(uq::GaussianProcess process)
{
    const uq::ProcessLeaveOneOut out = uq::held_out(process);
    const Eigen::VectorXd& y = process.data.y;
    const double square = mean_square(out);
    AnswerSurrogate s;
    s.inflation = uq::inflation_of(out);
    s.left_out = std::sqrt(square);
    s.q2 = 1.0 - square / (y.array() - y.mean()).square().mean();
    s.process = std::move(process);
    return s;
}

} // namespace

AnswerPoints joined(const AnswerPoints& a, const AnswerPoints& b)
{
    AnswerPoints all{Eigen::MatrixXd(a.u.rows() + b.u.rows(), a.u.cols()),
                     Eigen::VectorXd(a.y.size() + b.y.size())};
    all.u << a.u, b.u;
    all.y << a.y, b.y;
    return all;
}

AnswerSurrogate fit_answer(const AnswerPoints& points)
{
    if (is_constant(points.y)) {
        AnswerSurrogate same;
        same.constant = points.y.mean();
        same.q2 = 1.0;
        return same;
    }
    std::optional<uq::GaussianProcess> best;
    double least = std::numeric_limits<double>::infinity();
    std::string why;
    for (const auto kernel :
         {uq::ProcessKernel::matern_52, uq::ProcessKernel::squared_exponential})
        for (const auto trend : {uq::ProcessTrend::constant, uq::ProcessTrend::linear}) try {
                uq::GaussianProcess one =
                    uq::fit_process({points.u, points.y}, {.kernel = kernel, .trend = trend});
                const double square = mean_square(uq::leave_one_out(one));
                if (best && !(square < least)) continue;
                least = square;
                best = std::move(one);
            } catch (const std::invalid_argument& bad) { // no factor: another may have one
                why = bad.what();
            }
    if (!best) throw std::invalid_argument(why);
    return judged(*std::move(best));
}

double noise_of(const AnswerSurrogate& a)
{
    return a.process ? a.inflation * a.process->parameters.noise : 0.0;
}

uq::AnswerModel answer_model(std::vector<AnswerSurrogate> answers, bool deterministic)
{
    const auto shared =
        std::make_shared<const std::vector<AnswerSurrogate>>(std::move(answers));
    return [shared, deterministic](const Eigen::VectorXd& u) {
        const auto n = static_cast<Eigen::Index>(shared->size());
        uq::ModelAnswers all{Eigen::VectorXd(n), Eigen::VectorXd(n)};
        for (Eigen::Index i = 0; i < n; ++i) {
            const AnswerSurrogate& a = (*shared)[static_cast<std::size_t>(i)];
            all.mean(i) = a.constant;
            all.variance(i) = deterministic ? noise_of(a) : 0.0;
            if (!a.process) continue;
            const uq::ProcessPrediction p = uq::predict(*a.process, u.transpose());
            all.mean(i) = p.mean(0);
            all.variance(i) += a.inflation * p.variance(0);
        }
        return all;
    };
}

} // namespace app
