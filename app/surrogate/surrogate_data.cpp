#include "app/surrogate/surrogate_data.hpp"

#include "app/text/config_error.hpp"
#include "app/text/words.hpp"
#include "uq/surrogates/polynomials.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace app {

const WallNumber& surrogate_response(std::string_view name)
{
    std::vector<std::string_view> names;
    for (const WallNumber& r : std::span(kWallNumbers).first<kJudged>()) {
        if (r.name == name) return r;
        names.push_back(r.name);
    }
    throw ConfigError("drystone", 0, "--of",
                      in_quotes(name) + " is no response; " + suggestion(name, names));
}

std::vector<std::size_t> surrogate_inputs(const StudyWalls& walls)
{
    std::vector<std::size_t> varying;
    for (std::size_t k = 0; k < walls.inputs.size(); ++k) {
        const StoredInput& input = walls.inputs[k];
        if (!input.marginal)
            throw ConfigError(
                walls.name, 0, input.key,
                "its distribution is not in the file; run the study again with this "
                "version");
        if (!std::holds_alternative<uq::Constant>(input.marginal->shape)) varying.push_back(k);
    }
    if (varying.empty())
        throw ConfigError(walls.name, 0, "",
                          "nothing is random in this study; give keys a distribution, such as "
                          "joint.friction_angle = normal(mean 31.8 deg, cov 0.20)");
    return varying;
}

namespace {

Eigen::VectorXd standardised(const Eigen::VectorXd& x)
{
    if (x.size() == 0) return x; // no wall has the response
    const Eigen::ArrayXd off = x.array() - x.mean();
    const double sd = std::sqrt(off.square().mean());
    return sd > 0.0 ? Eigen::VectorXd(off / sd) : Eigen::VectorXd::Zero(x.size());
}

bool varies_inside(const StudyWalls& walls, const std::vector<std::size_t>& inputs)
{
    return walls.study.uq.spatial != Spatial::none ||
           std::ranges::any_of(inputs,
                               [&](std::size_t k) { return walls.inputs[k].count > 1; });
}

} // namespace

std::string no_coordinates(const StudyWalls& walls, const std::vector<std::size_t>& inputs)
{
    if (!varies_inside(walls, inputs)) return {};
    return "Inputs vary from joint to joint (uq.spatial), and a surrogate takes one value per "
           "wall; run a study with uq.spatial = none for one.";
}

Eigen::MatrixXd wall_coordinates(const StudyWalls& walls, const WallList& list,
                                 const std::vector<std::size_t>& inputs)
{
    Eigen::MatrixXd c(static_cast<Eigen::Index>(list.size()),
                      static_cast<Eigen::Index>(inputs.size()));
    for (std::size_t j = 0; j < inputs.size(); ++j) {
        const StoredInput& input = walls.inputs[inputs[j]];
        for (std::size_t i = 0; i < list.size(); ++i)
            c(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                uq::coordinate(*input.marginal, list[i]->inputs[inputs[j]] / input.scale);
    }
    return c;
}

SurrogatePoints surrogate_points(const StudyWalls& walls, std::size_t level,
                                 const std::vector<std::size_t>& inputs,
                                 const WallNumber& response, std::size_t most)
{
    const StudyLevel& from = walls.levels[level];
    SurrogatePoints p;
    p.stress = from.stress;
    p.failed = from.failed_walls.size();
    std::vector<double> y;
    WallList used;
    for (const StudyWall& w : from.walls) {
        const double value = response.reading(w.reading, walls.height);
        if (std::isfinite(value) && response.is_bound(w.reading))
            p.bounds.push_back(w.key);
        else if (!std::isfinite(value))
            p.without.push_back(w.key);
        else if (used.size() == most)
            ++p.beyond;
        else {
            used.push_back(&w);
            y.push_back(value * response.unit.scale);
        }
    }
    const auto n = static_cast<Eigen::Index>(used.size());
    const auto d = static_cast<Eigen::Index>(inputs.size());
    p.x.resize(n, d);
    p.coordinates.resize(n, d);
    p.y = Eigen::Map<const Eigen::VectorXd>(y.data(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const StudyWall& w = *used[static_cast<std::size_t>(i)];
        p.sample.push_back(w.key.sample);
        for (Eigen::Index j = 0; j < d; ++j)
            p.x(i, j) = w.inputs[inputs[static_cast<std::size_t>(j)]];
    }
    p.no_coordinates = no_coordinates(walls, inputs);
    if (p.no_coordinates.empty())
        p.coordinates = wall_coordinates(walls, used, inputs);
    else {
        p.no_coordinates += " Cramer-von Mises and HSIC are those of the means over the joints "
                            "of a wall.";
        for (Eigen::Index j = 0; j < d; ++j) p.coordinates.col(j) = standardised(p.x.col(j));
    }
    return p;
}

} // namespace app
