#pragma once
/// The samples of a study.

#include "uq/designs/design_kind.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace app {

enum class Spatial {
    none,        ///< one value per wall
    independent, ///< one per joint, from a design over walls and joints
    stratified,  ///< one per joint, a Latin hypercube over the joints inside each wall
    correlated   ///< one per joint, a random field over the joints
};

enum class FieldKernel {
    exponential,
    squared_exponential,
    exponential_l1,
    matern,
    same_course, ///< uq.group_correlation between joints of one course, 0 between courses
    same_unit,   ///< the same of one unit
    all          ///< the same of the whole wall
};

/// Quantity that a stopping rule looks at: uq.samples alone, or a row of kWallNumbers, or the
/// share of mixed walls.
constexpr int kNoStop = -1, kStopAtMixedShare = -2;

struct UqInput {
    uq::DesignKind design = uq::DesignKind::latin_random;
    int samples = 50;       ///< walls per stress level, >= 1
    std::uint64_t seed = 1; ///< of the design
    bool shared = false;    ///< the same samples under every stress level
    Spatial spatial = Spatial::none;
    FieldKernel kernel = FieldKernel::exponential;
    std::vector<double> correlation_length; ///< [m]; two for exponential_l1: along x and z
    double matern_nu = 1.5;                 ///< smoothness [-]
    double group_correlation = 0.5;         ///< [-], in [0, 1]
    int stop = kNoStop;            ///< kNoStop, kStopAtMixedShare or a row of kWallNumbers
    double stop_half_width = 0.05; ///< of the 95 % interval [-], > 0
    int most_samples = 1000;       ///< upper limit of the stopping rule
    int audit = 0;        ///< walls of each stress that are pushed again more slowly, >= 0
    std::string pearson;  ///< "joint.friction_angle joint.stiffness_factor 0.3, ..."
    std::string together; ///< keys whose empirical values are read row by row; empty: none
    std::string drawn;    ///< one wall alone (app/study/pushed/drawn_wall.hpp); empty: all
};

} // namespace app
