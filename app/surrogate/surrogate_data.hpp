#pragma once
/// Walls of a stored study as points of a surrogate: random values and one response.

#include "app/reading/wall_numbers.hpp"
#include "app/study/stored/study_walls.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// Larger studies are learned from their first walls: the cost grows with the cube.
constexpr std::size_t kMostSurrogateWalls = 600; // choice

struct SurrogatePoints {
    double stress = 0.0;               ///< [Pa]
    std::vector<std::uint32_t> sample; ///< numbers of the walls
    Eigen::MatrixXd x;                 ///< shown values of the inputs, walls x inputs
    /// As uq/surrogates/polynomials.hpp has them; standardised values where there are none.
    Eigen::MatrixXd coordinates;
    std::string no_coordinates;   ///< why there are none: a sentence; empty: there are
    Eigen::VectorXd y;            ///< shown value of the response
    std::vector<WallKey> without; ///< the response is not defined
    std::vector<WallKey> bounds;  ///< the push ended before: only a lower bound is known
    std::size_t failed = 0,
                beyond = 0; ///< walls that gave no result; more than were asked for
};

/// One of the first kJudged rows of kWallNumbers.
/// @throws ConfigError about --of naming those that there are
[[nodiscard]] const WallNumber& surrogate_response(std::string_view name);

/// Places in StudyWalls::inputs of those that vary.
/// @throws ConfigError where nothing is random, or the distribution of an input is not known
[[nodiscard]] std::vector<std::size_t> surrogate_inputs(const StudyWalls& walls);

/// Why the inputs of a wall have no coordinates: a sentence; empty: they have.
[[nodiscard]] std::string no_coordinates(const StudyWalls& walls,
                                         const std::vector<std::size_t>& inputs);

/// Coordinates of walls, a row for each, of inputs that have them.
[[nodiscard]] Eigen::MatrixXd wall_coordinates(const StudyWalls& walls, const WallList& list,
                                               const std::vector<std::size_t>& inputs);

/// Inputs that vary from joint to joint count with their means over the joints of a wall. These
/// have no coordinates, so that no surrogate is learned from them.
/// @param most walls, the first that have the response
[[nodiscard]] SurrogatePoints surrogate_points(const StudyWalls& walls, std::size_t level,
                                               const std::vector<std::size_t>& inputs,
                                               const WallNumber& response,
                                               std::size_t most = kMostSurrogateWalls);

} // namespace app
