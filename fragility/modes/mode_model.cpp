#include "fragility/modes/mode_model.hpp"

#include "core/fit_factors.hpp"
#include "core/matrix_factors.hpp"
#include "fragility/laws/standard_law.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <vector>

namespace fragility {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Change of ln(P_k / P_0) by the last step [-] above which a search has not come to rest.
constexpr double kAtRest = 1e-4;

ModeModel refused(ModelOutcome outcome, std::string reason)
{
    ModeModel m;
    m.outcome = outcome;
    m.reason = std::move(reason);
    return m;
}

std::optional<ModeModel> screen(const ModeData& d, ModePenalty penalty)
{
    if (d.counts.rows() == 0 || d.counts.size() == 0)
        return refused(ModelOutcome::no_data, "no data");
    if (d.covariates.rows() != d.counts.rows())
        return refused(ModelOutcome::invalid_value,
                       std::to_string(d.covariates.rows()) + " rows of covariates, " +
                           std::to_string(d.counts.rows()) + " of counts");
    if (!d.covariates.allFinite() || !d.counts.allFinite() || d.counts.minCoeff() < 0.0)
        return refused(ModelOutcome::invalid_value,
                       "covariates and counts must be finite, counts not negative");
    if (d.counts.sum() <= 0.0) return refused(ModelOutcome::no_data, "no walls");
    if (d.counts.cols() < 2)
        return refused(ModelOutcome::no_contrast, "at least two modes are needed");
    if (penalty == ModePenalty::firth) return std::nullopt;
    const VectorXd totals = d.counts.colwise().sum();
    if ((totals.array() > 0.0).count() < 2)
        return refused(ModelOutcome::no_contrast, "all walls are of one mode");
    for (Index k = 0; k < totals.size(); ++k)
        if (totals[k] == 0.0)
            return refused(ModelOutcome::absent_mode,
                           "mode " + std::to_string(k) +
                               " never occurs: its coefficients are not finite");
    return std::nullopt;
}

/// Only rows with walls; covariates from 0 to 1, so that steps and ranks can be judged.
struct Scaled {
    MatrixXd design, counts;
    VectorXd shift, scale;
};

Scaled scaled(const ModeData& d)
{
    std::vector<Index> rows;
    for (Index i = 0; i < d.counts.rows(); ++i)
        if (d.counts.row(i).sum() > 0.0) rows.push_back(i);
    MatrixXd x = d.covariates(rows, Eigen::all);
    Scaled s;
    s.counts = d.counts(rows, Eigen::all);
    s.shift = x.cols() > 0 ? VectorXd(x.colwise().minCoeff()) : VectorXd();
    s.scale = VectorXd::Ones(x.cols());
    for (Index j = 0; j < x.cols(); ++j) {
        x.col(j).array() -= s.shift[j];
        if (x.col(j).maxCoeff() > 0.0) s.scale[j] = x.col(j).maxCoeff();
        x.col(j) /= s.scale[j];
    }
    s.design = with_constant(x);
    return s;
}

/// Along `step` no wall's own mode ever loses against another: the likelihood grows for good
/// (Albert and Anderson 1984, Biometrika 71, 1-10).
bool separates(const Scaled& s, const VectorXd& step)
{
    const Index p = s.design.cols();
    const Index modes = s.counts.cols();
    const auto predictor = [&](Index row, Index mode) {
        return mode == 0 ? 0.0 : s.design.row(row).dot(step.segment((mode - 1) * p, p));
    };
    double largest = 0.0;
    double worst = 0.0;
    for (Index i = 0; i < s.design.rows(); ++i)
        for (Index own = 0; own < modes; ++own)
            for (Index other = 0; other < modes && s.counts(i, own) > 0.0; ++other) {
                const double lead = predictor(i, own) - predictor(i, other);
                largest = std::max(largest, lead);
                worst = std::min(worst, lead);
            }
    return largest > 0.0 && worst > -1e-4 * largest;
}

double largest_move(const Scaled& s, const VectorXd& step)
{
    const Index p = s.design.cols();
    double largest = 0.0;
    for (Index k = 0; k + 1 < s.counts.cols(); ++k)
        largest = std::max(largest, (s.design * step.segment(k * p, p)).cwiseAbs().maxCoeff());
    return largest;
}

/// beta of the scaled covariates to beta of the covariates as given.
MatrixXd unscaling(const Scaled& s, Index others)
{
    const Index p = s.design.cols();
    MatrixXd one = MatrixXd::Identity(p, p);
    for (Index j = 1; j < p; ++j) {
        one(j, j) = 1.0 / s.scale[j - 1];
        one(0, j) = -s.shift[j - 1] / s.scale[j - 1];
    }
    MatrixXd all = MatrixXd::Zero(others * p, others * p);
    for (Index k = 0; k < others; ++k) all.block(k * p, k * p, p, p) = one;
    return all;
}

ModeModel completed(const Scaled& s, const Maximum& m, ModePenalty penalty)
{
    const Index p = s.design.cols();
    const Index others = s.counts.cols() - 1;
    const MatrixXd back = unscaling(s, others);
    const VectorXd beta = back * m.at;
    const Local l = mode_likelihood(s.design, s.counts, m.at);
    ModeModel model;
    model.outcome = ModelOutcome::converged;
    model.penalty = penalty;
    model.covariance = back * inverse_information(l.hessian) * back.transpose();
    model.coefficients.resize(others, p);
    model.std_errors.resize(others, p);
    for (Index k = 0; k < others; ++k)
        for (Index j = 0; j < p; ++j) {
            model.coefficients(k, j) = beta[k * p + j];
            model.std_errors(k, j) = std::sqrt(model.covariance(k * p + j, k * p + j));
        }
    model.log_likelihood = l.value;
    model.deviance = -2.0 * l.value;
    if (penalty == ModePenalty::none)
        model.aic = model.deviance + 2.0 * static_cast<double>(beta.size());
    model.n = s.counts.sum();
    return model;
}

void check(const ModeModel& model, const VectorXd& covariates)
{
    if (model.outcome != ModelOutcome::converged)
        throw std::invalid_argument("mode model: there is none: " + model.reason);
    if (covariates.size() + 1 != model.coefficients.cols())
        throw std::invalid_argument("mode model: needs " +
                                    std::to_string(model.coefficients.cols() - 1) +
                                    " covariates, has " + std::to_string(covariates.size()));
}

} // namespace

ModeModel fit_modes(const ModeData& data, ModePenalty penalty)
{
    if (auto no = screen(data, penalty)) return *no;
    const Scaled s = scaled(data);
    if (core::rank(s.design) < s.design.cols())
        return refused(ModelOutcome::collinear,
                       "a covariate is constant or a combination of the others");
    const Index size = (s.counts.cols() - 1) * s.design.cols();
    const auto f = [&](const VectorXd& beta) {
        return penalty == ModePenalty::firth
                   ? penalised_mode_likelihood(s.design, s.counts, beta)
                   : mode_likelihood(s.design, s.counts, beta);
    };
    // First only until little is to be had: where data are separated, the step then still goes
    // the way it runs, and is not yet spoilt by a singular information.
    const Maximum rough = maximise(f, VectorXd::Zero(size), {.tolerance = 1e-12});
    const Maximum m = maximise(f, rough.at);
    if (penalty == ModePenalty::none && largest_move(s, rough.last_step) > kAtRest &&
        largest_move(s, m.last_step) > kAtRest && separates(s, rough.last_step))
        return refused(ModelOutcome::separated,
                       "the covariates separate the modes: coefficients are not finite");
    if (!m.converged ||
        (penalty == ModePenalty::none && largest_move(s, m.last_step) > kAtRest))
        return refused(ModelOutcome::not_converged,
                       "not converged after " + std::to_string(m.iterations) + " iterations");
    return completed(s, m, penalty);
}

ModeModel fit_modes_safely(const ModeData& data)
{
    ModeModel plain = fit_modes(data);
    if (plain.outcome != ModelOutcome::separated && plain.outcome != ModelOutcome::absent_mode)
        return plain;
    ModeModel firth = fit_modes(data, ModePenalty::firth);
    firth.reason = plain.reason + (firth.reason.empty() ? "" : "; " + firth.reason);
    return firth;
}

VectorXd mode_probabilities(const ModeModel& model, const VectorXd& covariates)
{
    check(model, covariates);
    VectorXd eta = VectorXd::Zero(model.coefficients.rows() + 1);
    eta.tail(model.coefficients.rows()) =
        model.coefficients.rightCols(covariates.size()) * covariates +
        model.coefficients.col(0);
    const VectorXd e = (eta.array() - eta.maxCoeff()).exp();
    return e / e.sum();
}

ModeProbability mode_probability(const ModeModel& model, int mode, const VectorXd& covariates,
                                 double confidence)
{
    const VectorXd p = mode_probabilities(model, covariates);
    if (mode < 0 || mode >= p.size())
        throw std::invalid_argument("mode model: has no mode " + std::to_string(mode));
    if (!(confidence > 0.0 && confidence < 1.0))
        throw std::invalid_argument("mode model: confidence must be in (0, 1)");
    const Index width = model.coefficients.cols();
    VectorXd x(width);
    x << 1.0, covariates;
    VectorXd gradient((p.size() - 1) * width); // of the logit
    double other = 0.0;
    for (Index k = 0; k < p.size(); ++k) other += k == mode ? 0.0 : p[k];
    for (Index k = 1; k < p.size(); ++k)
        gradient.segment((k - 1) * width, width) = (k == mode ? 1.0 : -p[k] / other) * x;
    const double error = std::sqrt(gradient.dot(model.covariance * gradient));
    const double z = core::fit_normal_factor(confidence);
    const double logit = std::log(p[mode]) - std::log(other);
    return {p[mode],
            p[mode] * other * error,
            {StandardLogistic::cdf(logit - z * error), StandardLogistic::cdf(logit + z * error),
             confidence}};
}

} // namespace fragility
