#include "app/calibration/calibration_pushes.hpp"

#include "app/input/keys/limit_state_text.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "uq/designs/stream.hpp"

#include <cmath>
#include <limits>

namespace app {

WallDraw wall_at(const uq::SpatialPlan& others, const CalibratedInputs& inputs,
                 const Eigen::VectorXd& u, std::uint64_t seed, std::uint64_t row)
{
    uq::Stream random(seed, row, uq::Purpose::prediction);
    Eigen::VectorXd normal(others.n_columns);
    for (double& z : normal) z = random.normal();
    WallDraw draw{uq::draw(others, normal, random)};
    const Eigen::VectorXd values = to_values(inputs, u);
    for (std::size_t i = 0; i < inputs.inputs.size(); ++i)
        draw.values[inputs.inputs[i].place] = {values(static_cast<Eigen::Index>(i))};
    return draw;
}

bool is_pushed_again(const PreparedStudy& ready)
{
    return !has_layouts(ready.study.geometry) &&
           !pushes_both_ways(ready.study.geometry, ready.study.load, ready.study.source,
                             ready.layout) &&
           ready.study.uq.spatial == Spatial::none;
}

Eigen::MatrixXd pushed_answers(const PreparedStudy& ready, const CalibratedInputs& inputs,
                               const CalibrationData& data, const Eigen::MatrixXd& u,
                               std::uint64_t seed, int threads,
                               const std::function<void(std::size_t)>& seen)
{
    const std::vector<CalibratedAnswer>& answers = data.answers;
    const ReadingRules rules = reading_rules(ready.study);
    const auto rows = static_cast<std::size_t>(u.rows());
    const std::size_t levels = ready.study.load.vertical_stress.size();
    Eigen::MatrixXd y =
        Eigen::MatrixXd::Constant(u.rows(), static_cast<Eigen::Index>(answers.size()),
                                  std::numeric_limits<double>::quiet_NaN());
    const uq::SpatialPlan others =
        value_plan(ready.study, ready.study.source, ready.layout, false);
    std::size_t done = 0;
    PushList list;
    list.size = rows * levels;
    list.wall = [&](std::size_t i) -> WantedWall {
        const std::size_t row = i / levels;
        return {static_cast<int>(i % levels),
                wall_at(others, inputs, u.row(static_cast<Eigen::Index>(row)).transpose(), seed,
                        row)};
    };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        for (std::size_t a = 0; a < answers.size(); ++a) {
            if (answers[a].level != i % levels || !wall.reading.no_reading.empty()) continue;
            const double value = shown(data.quantities[answers[a].kind],
                                       {wall.reading, wall.displacement, wall.force}, rules);
            if (value > 0.0 && std::isfinite(value))
                y(static_cast<Eigen::Index>(i / levels), static_cast<Eigen::Index>(a)) =
                    std::log(value);
        }
        seen(++done);
    };
    push_walls(ready.study, model_of(ready), bare(push_plan(ready.study)), list, threads);
    return y;
}

std::vector<SurrogateMiss> missed(const uq::AnswerModel& model, const Eigen::MatrixXd& u,
                                  const Eigen::MatrixXd& pushed)
{
    std::vector<SurrogateMiss> all(static_cast<std::size_t>(pushed.cols()));
    for (Eigen::Index i = 0; i < u.rows(); ++i) {
        const uq::ModelAnswers m = model(u.row(i).transpose());
        for (Eigen::Index a = 0; a < pushed.cols(); ++a) {
            if (std::isnan(pushed(i, a))) continue;
            SurrogateMiss& miss = all[static_cast<std::size_t>(a)];
            ++miss.walls;
            miss.root_mean_square += std::pow(pushed(i, a) - m.mean(a), 2);
        }
    }
    for (SurrogateMiss& miss : all)
        if (miss.walls > 0)
            miss.root_mean_square =
                std::sqrt(miss.root_mean_square / static_cast<double>(miss.walls));
    return all;
}

} // namespace app
