#include "app/calibration/calibration_run.hpp"

#include "app/study/pushed/interrupt.hpp"
#include "app/text/config_error.hpp"
#include "core/sample_quantile.hpp"
#include "uq/designs/stream.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <stdexcept>
#include <utility>

namespace app {
namespace {

/// Calls work(i) for all i below n on so many threads; each i is done once, by any of them.
void on_threads(std::size_t n, int threads, const std::function<void(std::size_t)>& work)
{
    std::atomic<std::size_t> next = 0;
    const auto run = [&] {
        for (std::size_t i = next++; i < n && !interrupted(); i = next++) work(i);
    };
    std::vector<std::future<void>> others;
    const auto most = std::min(n, static_cast<std::size_t>(std::max(1, threads)));
    for (std::size_t k = 1; k < most; ++k)
        others.push_back(std::async(std::launch::async, run));
    run();
    for (std::future<void>& other : others) other.get();
    end_if_interrupted();
}

std::vector<AnswerSurrogate> surrogates_of(const StudyFile& source, const CalibrationData& data,
                                           int threads)
{
    std::vector<AnswerSurrogate> all(data.answers.size());
    try {
        on_threads(all.size(), threads,
                   [&](std::size_t i) { all[i] = fit_answer(data.answers[i].points); });
    } catch (const std::invalid_argument& bad) {
        throw error_at(source, "calibration.inputs",
                       std::string("no surrogate of the walls can be fitted: ") + bad.what());
    }
    return all;
}

uq::CalibrationProblem problem_of(const CalibrationInput& calibration,
                                  const CalibratedInputs& inputs, const CalibrationData& data,
                                  const CalibrationRun& run)
{
    uq::CalibrationProblem p;
    p.inputs = static_cast<Eigen::Index>(inputs.inputs.size());
    p.own = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(data.answers.size()));
    for (std::size_t i = 0; i < data.answers.size(); ++i) {
        p.quantity.push_back(data.answers[i].kind);
        if (!inputs.all) p.own(static_cast<Eigen::Index>(i)) = noise_of(run.surrogates[i]);
    }
    for (const UsedTest& t : data.tests)
        p.tests.push_back({t.answer, std::log(t.value), t.at_least, t.error});
    p.model = run.model;
    p.prior_scale = calibration.scatter;
    return p;
}

/// Chains that only tell where to push walls, or what the tests under other stresses say.
uq::CalibrationOptions short_chains()
{
    return {.metropolis = {.warm_up = 3000, .draws = 4000}, .longer = 1, .evidence = false};
}

Taught taught(const uq::CalibrationProblem& problem, std::uint64_t seed,
              uq::CalibrationOptions o = {})
{
    o.metropolis.seed = seed;
    Taught t;
    t.posterior = uq::calibrate(problem, o);
    t.points = uq::calibration_points(problem, t.posterior, kPosteriorPoints);
    t.further = uq::further_tests(problem, t.points, seed);
    return t;
}

/// The same problem without the tests under a stress; nothing where none or all are there.
std::optional<uq::CalibrationProblem>
without_level(uq::CalibrationProblem p, const CalibrationData& data, std::size_t level)
{
    const std::size_t before = p.tests.size();
    std::erase_if(p.tests, [&](const uq::MeasuredAnswer& t) {
        return data.answers[t.answer].level == level;
    });
    if (p.tests.size() == before || p.tests.empty()) return {};
    return p;
}

void fit_surrogates(CalibrationRun& run, const StudyFile& source,
                    const CalibratedInputs& inputs, const CalibrationData& data, int threads)
{
    run.surrogates = surrogates_of(source, data, threads);
    run.model = answer_model(run.surrogates, inputs.all);
}

/// The posterior that the study asks for, as far as it tells where to push walls.
Taught first_taught(const CalibrationRun& run, const UqInput& uq,
                    const CalibrationInput& calibration, const CalibratedInputs& inputs,
                    const CalibrationData& data)
{
    uq::CalibrationProblem problem = problem_of(calibration, inputs, data, run);
    problem.discrepancy = calibration.discrepancy;
    return taught(problem, uq.seed, short_chains());
}

void teach_both(CalibrationRun& run, const UqInput& uq, const CalibrationInput& calibration,
                const CalibratedInputs& inputs, const CalibrationData& data, int threads)
{
    const uq::CalibrationProblem problem = problem_of(calibration, inputs, data, run);
    on_threads(2, threads, [&](std::size_t i) {
        uq::CalibrationProblem p = problem;
        p.discrepancy = i == 0;
        (i == 0 ? run.with : run.without) = taught(p, uq.seed);
    });
}

/// Coordinates of points evenly over the posterior.
/// @param part 0, or 1 for other points
Eigen::MatrixXd checked_points(const Taught& t, std::size_t part)
{
    const std::size_t stride = t.points.size() / kCheckedPoints;
    Eigen::MatrixXd u(static_cast<Eigen::Index>(kCheckedPoints), t.points.front().z.size());
    for (std::size_t i = 0; i < kCheckedPoints; ++i)
        u.row(static_cast<Eigen::Index>(i)) =
            t.points[i * stride + (1 + part) * stride / 3].z.transpose();
    return u;
}

void add_walls(CalibrationData& data, const Eigen::MatrixXd& u, const Eigen::MatrixXd& pushed)
{
    for (std::size_t a = 0; a < data.answers.size(); ++a)
        for (Eigen::Index i = 0; i < u.rows(); ++i) {
            const double y = pushed(i, static_cast<Eigen::Index>(a));
            if (!std::isnan(y))
                data.answers[a].points =
                    joined(data.answers[a].points, {u.row(i), Eigen::VectorXd::Constant(1, y)});
        }
}

bool is_large(const std::vector<SurrogateMiss>& miss)
{
    return std::ranges::any_of(
        miss, [](const SurrogateMiss& m) { return m.root_mean_square > kLargeMiss; });
}

/// Pushes true walls at points of the posterior; where the surrogates miss them by much, learns
/// them, and pushes others.
void check_by_pushes(CalibrationRun& run, const PreparedStudy& ready,
                     const CalibratedInputs& inputs, CalibrationData& data, int threads,
                     const CalibrationSeen& seen)
{
    const auto walls =
        static_cast<double>(kCheckedPoints * ready.study.load.vertical_stress.size());
    const auto pushed = [&](const Eigen::MatrixXd& u, std::uint64_t part) {
        return pushed_answers(ready, inputs, data, u,
                              uq::replicate_seed(ready.study.uq.seed, 1 + part), threads,
                              [&](std::size_t done) {
                                  seen(static_cast<double>(done) / walls,
                                       "pushing walls at points of the posterior");
                              });
    };
    const Study& study = ready.study;
    const auto points = [&](std::size_t part) {
        return checked_points(first_taught(run, study.uq, study.calibration, inputs, data),
                              part);
    };
    const Eigen::MatrixXd u = points(0);
    const Eigen::MatrixXd y = pushed(u, 0);
    run.miss = missed(run.model, u, y);
    if (!is_large(run.miss)) return;
    run.first_miss = run.miss;
    add_walls(data, u, y);
    seen(0.0, "learning these walls");
    fit_surrogates(run, study.source, inputs, data, threads);
    const Eigen::MatrixXd other = points(1);
    run.miss = missed(run.model, other, pushed(other, 1));
}

/// ln of the answers of walls as the prior has them.
Eigen::MatrixXd prior_answers(const uq::CalibrationProblem& p, std::uint64_t seed)
{
    Eigen::MatrixXd y(static_cast<Eigen::Index>(kPosteriorPoints),
                      static_cast<Eigen::Index>(p.quantity.size()));
    for (std::size_t k = 0; k < kPosteriorPoints; ++k) {
        uq::Stream random(seed, k, uq::Purpose::monte_carlo);
        Eigen::VectorXd z(p.inputs);
        for (double& v : z) v = random.normal();
        const uq::ModelAnswers m = p.model(z);
        for (Eigen::Index i = 0; i < y.cols(); ++i)
            y(static_cast<Eigen::Index>(k), i) =
                m.mean(i) + std::sqrt(m.variance(i) + p.own(i)) * random.normal();
    }
    return y;
}

} // namespace

const Taught& answer_of(const CalibrationInput& calibration, const CalibrationRun& run)
{
    return calibration.discrepancy ? run.with : run.without;
}

CalibrationRun run_calibration(const PreparedStudy& ready, const CalibratedInputs& inputs,
                               CalibrationData& data, int threads, const CalibrationSeen& seen)
{
    const Study& study = ready.study;
    CalibrationRun run;
    seen(0.0, "learning the walls");
    fit_surrogates(run, study.source, inputs, data, threads);
    if (is_pushed_again(ready)) check_by_pushes(run, ready, inputs, data, threads, seen);
    seen(0.0, "drawing from the posterior");
    teach_both(run, study.uq, study.calibration, inputs, data, threads);
    seen(0.6, "leaving out one stress after the other");
    uq::CalibrationProblem problem = problem_of(study.calibration, inputs, data, run);
    problem.discrepancy = study.calibration.discrepancy;
    run.prior = prior_answers(problem, study.uq.seed);
    run.left_out.resize(study.load.vertical_stress.size());
    on_threads(run.left_out.size(), threads, [&](std::size_t level) {
        const auto p = without_level(problem, data, level);
        if (!p) return;
        uq::CalibrationOptions options = short_chains();
        options.longer = 2;
        Taught t = taught(*p, study.uq.seed, options);
        run.left_out[level] = {std::move(t.further), uq::has_converged(t.posterior)};
    });
    return run;
}

DrawsSummary summary_of(std::vector<double> draws)
{
    std::ranges::sort(draws);
    constexpr double kTail = 0.5 * (1.0 - kTableShare);
    return {core::sample_quantile(draws, 0.5),
            {core::sample_quantile(draws, kTail), core::sample_quantile(draws, 1.0 - kTail),
             kTableShare}};
}

} // namespace app
