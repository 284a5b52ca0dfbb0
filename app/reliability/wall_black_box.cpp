#include "app/reliability/wall_black_box.hpp"

#include "app/reading/wall_numbers.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "dem/block/model.hpp"

#include <limits>
#include <memory>

namespace app {
namespace {

constexpr auto kWidth = static_cast<Eigen::Index>(kJudged);

/// State shared by all calls; the model may outlive its maker.
struct Shared {
    Study study;
    SamplePlan plan;
    dem::Model model;
    int level, threads;
};

/// Why there is no answer; empty if there is.
std::string answer(const PushedWall& w, Eigen::Ref<Eigen::RowVectorXd> y)
{
    for (std::size_t i = 0; i < kJudged; ++i)
        y(static_cast<Eigen::Index>(i)) = kWallNumbers[i].reading(w.reading, w.loads.height);
    if (!w.reading.no_reading.empty()) return std::string(w.reading.no_reading);
    return y.allFinite() ? std::string() : std::string(w.reading.ultimate.reason);
}

uq::Responses ask(const Shared& s, const uq::Samples& samples)
{
    const Eigen::Index n = samples.x.rows();
    uq::Responses r;
    r.y = Eigen::MatrixXd::Constant(n, kWidth, std::numeric_limits<double>::quiet_NaN());
    r.failure.resize(static_cast<std::size_t>(n));
    PushList list;
    list.size = static_cast<std::size_t>(n);
    list.wall = [&](std::size_t i) -> WantedWall {
        const Eigen::VectorXd row = samples.x.row(static_cast<Eigen::Index>(i));
        return {s.level, unflattened(s.plan, row)};
    };
    list.done = [&](std::size_t i, const WallDraw&, PushedWall&& wall) {
        Eigen::RowVectorXd y(kWidth);
        r.failure[i] = answer(wall, y);
        if (r.failure[i].empty()) r.y.row(static_cast<Eigen::Index>(i)) = y;
    };
    push_walls(s.study, s.model, bare(push_plan(s.study)), list, s.threads);
    return r;
}

} // namespace

void check_random(const std::vector<RandomInput>& random, const StudyFile& source,
                  const std::string& or_else)
{
    if (random.empty())
        throw error_at(
            source, "joint.friction_angle",
            "no value of this study is a distribution; write e.g. \"friction_angle = "
            "normal(mean 31.8 deg, cov 0.20)\"" +
                or_else);
}

SamplePlan any_wall_plan(Study study, const dem::Layout& layout)
{
    const std::vector<std::uint32_t> one = {1};
    study.uq.design = uq::DesignKind::monte_carlo;
    return sample_plan(study, study.load, study.source, layout, one);
}

uq::BlackBox wall_model(const PreparedStudy& ready, const SamplePlan& plan, int level,
                        int threads)
{
    const auto shared =
        std::make_shared<Shared>(Shared{ready.study, plan, model_of(ready), level, threads});
    return [shared](const uq::Samples& samples) { return ask(*shared, samples); };
}

uq::Map wall_map(const StudyFile& source, const SamplePlan& plan)
{
    if (plan.spatial == Spatial::stratified)
        throw error_at(source, "uq.spatial",
                       "stratified draws have no coordinates to search; write independent, "
                       "correlated or none");
    return [plan](const Eigen::MatrixXd& u) {
        Eigen::MatrixXd x;
        uq::Stream unused(0, 0, uq::Purpose::field);
        for (Eigen::Index i = 0; i < u.rows(); ++i) {
            const std::vector<double> row =
                flattened({uq::draw(plan.values, u.row(i).transpose(), unused)});
            if (i == 0) x.resize(u.rows(), static_cast<Eigen::Index>(row.size()));
            x.row(i) = Eigen::Map<const Eigen::RowVectorXd>(
                row.data(), static_cast<Eigen::Index>(row.size()));
        }
        return x;
    };
}

} // namespace app
