#pragma once
/// Cost against error over every setting that trades one for the other.

#include "dem/block/discretisation.hpp"
#include "dem/solver/ensemble.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <string>
#include <vector>

namespace bench {

/// A point of the diagram before it is run.
struct Setting {
    std::string family; ///< points of a family are joined by a line
    dem::Fidelity fidelity = dem::Fidelity::standard;
    dem::Discretisation discretisation = dem::discretisation_of(dem::Fidelity::standard);
    dem::SolverOptions solver;
    dem::Workers workers;
    bool is_default = false;
    double nodal_steps_per_mm = 0.0; ///< > 0: the paper's own scheme at this speed
};

/// And after. Errors against the fine zones at a slow drive, on the same walls.
struct Point {
    Setting setting;
    int walls = 0;
    double seconds = 0.0;     ///< core seconds per wall
    double peak_median = 0.0; ///< of |error of the peak force| [-]
    double peak_95 = 0.0;     ///< its 95 % quantile [-]
    double peak_mean = 0.0;   ///< error of the mean peak force [-]
    double ultimate =
        0.0; ///< |error| of the mean ultimate displacement, walls without a drop at their last [-]
    double close = 0.0;     ///< share of walls with d80 within 0.3 mm, or no drop in either [-]
    double same_mode = 0.0; ///< share of walls with the same failure mode [-]
    int failed = 0;
};

[[nodiscard]] std::vector<Setting> settings();

/// The two panels: peak force and ultimate displacement.
struct Panels {
    std::string peak, ultimate; ///< SVG
};
[[nodiscard]] Panels draw(const std::vector<Point>& points);

/// No other point is both cheaper and more exact.
[[nodiscard]] std::vector<const Point*> front(const std::vector<Point>& points,
                                              double Point::*error);

} // namespace bench
