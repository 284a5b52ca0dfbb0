#include "app/calibration/calibration_surrogate.hpp"

#include "uq/surrogates/process_fit.hpp"

#include <cmath>
#include <memory>
#include <stdexcept>

namespace app {
namespace {

bool is_constant(const Eigen::VectorXd& y) { return y.maxCoeff() - y.minCoeff() < 1e-9; }

/// The surrogate with this process, and what it is worth on walls left out.
AnswerSurrogate judged(uq::GaussianProcess process)
{
    const uq::ProcessLeaveOneOut out = uq::leave_one_out(process);
    const Eigen::VectorXd& y = process.data.y;
    const double square = out.residual.squaredNorm() / static_cast<double>(y.size());
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
    std::optional<AnswerSurrogate> best;
    if (is_constant(points.y)) {
        best.emplace();
        best->constant = points.y.mean();
        best->q2 = 1.0;
        return *best;
    }
    std::string why;
    for (const auto kernel :
         {uq::ProcessKernel::matern_52, uq::ProcessKernel::squared_exponential})
        for (const auto trend : {uq::ProcessTrend::constant, uq::ProcessTrend::linear}) try {
                AnswerSurrogate s = judged(
                    uq::fit_process({points.u, points.y}, {.kernel = kernel, .trend = trend}));
                if (!best || s.left_out < best->left_out) best = std::move(s);
            } catch (const std::invalid_argument& bad) { // no factor: another may have one
                why = bad.what();
            }
    if (!best) throw std::invalid_argument(why);
    return *best;
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
