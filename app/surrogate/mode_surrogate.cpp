#include "app/surrogate/mode_surrogate.hpp"

#include "app/surrogate/surrogate_fit.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <array>

namespace app {
namespace {

constexpr Eigen::Index kFolds = 10;

/// 1 where a wall has the mode.
Eigen::MatrixXd marks(const ModePoints& p, const std::vector<int>& modes)
{
    Eigen::MatrixXd counts =
        Eigen::MatrixXd::Zero(p.coordinates.rows(), static_cast<Eigen::Index>(modes.size()));
    for (std::size_t i = 0; i < p.mode.size(); ++i) {
        const auto place = std::ranges::find(modes, p.mode[i]) - modes.begin();
        counts(static_cast<Eigen::Index>(i), place) = 1.0;
    }
    return counts;
}

/// Probabilities of each wall by a model of the walls of all other folds; by their shares where
/// they have no model.
Eigen::MatrixXd held_out(const Eigen::MatrixXd& coordinates, const Eigen::MatrixXd& counts)
{
    Eigen::MatrixXd p(counts.rows(), counts.cols());
    for (Eigen::Index fold = 0; fold < kFolds; ++fold) {
        std::vector<Eigen::Index> kept, left;
        for (Eigen::Index i = 0; i < counts.rows(); ++i)
            (i % kFolds == fold ? left : kept).push_back(i);
        const Eigen::MatrixXd c = coordinates(kept, Eigen::all), n = counts(kept, Eigen::all);
        const fragility::ModeModel model = fragility::fit_modes_safely({c, n});
        const bool fitted = model.outcome == fragility::ModelOutcome::converged;
        const Eigen::RowVectorXd shares =
            n.colwise().sum() / static_cast<double>(std::max<std::size_t>(kept.size(), 1));
        for (const Eigen::Index i : left)
            p.row(i) = fitted ? Eigen::RowVectorXd(fragility::mode_probabilities(
                                                       model, coordinates.row(i).transpose())
                                                       .transpose())
                              : shares;
    }
    return p;
}

/// Mean square of what probabilities miss (Brier 1950, Mon. Weather Rev. 78, 1-3).
double brier(const Eigen::MatrixXd& probability, const Eigen::MatrixXd& counts)
{
    return (probability - counts).squaredNorm() / static_cast<double>(counts.rows());
}

double share_right(const Eigen::MatrixXd& probability, const Eigen::MatrixXd& counts)
{
    double right = 0.0;
    for (Eigen::Index i = 0; i < counts.rows(); ++i) {
        Eigen::Index likeliest = 0;
        probability.row(i).maxCoeff(&likeliest);
        right += counts(i, likeliest);
    }
    return right / static_cast<double>(counts.rows());
}

void judge(ModeSurrogate& s)
{
    if (!(s.skill > 0.0))
        s.doubts.push_back("The inputs do not tell the modes of walls left out apart (Brier "
                           "skill " +
                           number(s.skill, 2) + "): the shares of the modes say as much.");
}

} // namespace

ModePoints mode_points(const StudyWalls& walls, std::size_t level,
                       const std::vector<std::size_t>& inputs, std::size_t most)
{
    WallList used;
    for (const StudyWall& w : walls.levels[level].walls)
        if (used.size() < most) used.push_back(&w);
    ModePoints p;
    p.no_coordinates = no_coordinates(walls, inputs);
    if (p.no_coordinates.empty()) p.coordinates = wall_coordinates(walls, used, inputs);
    for (const StudyWall* const w : used) p.mode.push_back(mode_of(*w));
    return p;
}

ModeSurrogate fit_mode_surrogate(const ModePoints& points)
{
    ModeSurrogate s;
    s.walls = points.mode.size();
    for (const int mode : std::array{kRocking, kSliding, kMixed})
        if (std::ranges::count(points.mode, mode) > 0) s.modes.push_back(mode);
    if (s.walls < kFewestSurrogateWalls) {
        s.none = "Only " + counted(s.walls, "wall has", "walls have") +
                 " a mode; a model of them needs at least " +
                 std::to_string(kFewestSurrogateWalls) + ".";
        return s;
    }
    if (s.modes.size() == 1) {
        s.none = "The mode is the same on all " + std::to_string(s.walls) +
                 " walls: " + mode_name(s.modes.front()) + ".";
        return s;
    }
    if (!points.no_coordinates.empty()) {
        s.none = points.no_coordinates;
        return s;
    }
    const Eigen::MatrixXd counts = marks(points, s.modes);
    s.model = fragility::fit_modes_safely({points.coordinates, counts});
    if (s.model.outcome != fragility::ModelOutcome::converged) {
        s.none = "The modes have no model: " + s.model.reason + ".";
        return s;
    }
    const Eigen::MatrixXd p = held_out(points.coordinates, counts);
    const Eigen::MatrixXd shares = counts.colwise().mean().replicate(counts.rows(), 1);
    s.skill = 1.0 - brier(p, counts) / brier(shares, counts);
    s.right = share_right(p, counts);
    judge(s);
    return s;
}

} // namespace app
