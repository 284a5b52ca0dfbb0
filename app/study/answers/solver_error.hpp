#pragma once
/// Effect of the solver on the numbers of a study: the errors that each push estimates of
/// itself, by the speed of its drive and by its contact points, and the differences of an
/// audit. Tables, remarks, page and bounds take it from here.

#include "app/study/stored/study_walls.hpp"
#include "app/text/number_text.hpp"
#include "dem/solver/state/solver_options.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace app {

/// Whether the error of a wall is larger than the study asks for; an error that is not known is
/// not.
[[nodiscard]] inline bool misses_accuracy(double solver_error, const dem::SolverOptions& solver)
{
    return solver_error > solver.accuracy;
}

/// "0.62 %"
[[nodiscard]] inline std::string error_text(double error)
{
    return (error < 0.995 ? number(100.0 * error, 2) : fixed(100.0 * error, 0)) + " %";
}

/// Errors that the pushes estimate of their own forces.
struct WallErrors {
    std::vector<double> known;  ///< ascending [-]
    std::size_t unknown = 0;    ///< walls of a file that does not have it
    std::vector<WallKey> above; ///< walls that miss the accuracy
};
/// @param error StudyWall::solver_error or StudyWall::points_error
[[nodiscard]] WallErrors wall_errors(const StudyLevel& level, double StudyWall::*error,
                                     const dem::SolverOptions& solver);

/// |value / value of the slower push - 1| of one wall [-]; NaN: not defined on one of both.
struct AuditDifference {
    bool checked = false; ///< both pushes gave a result
    double peak = kUnknownError, ultimate = kUnknownError;
    bool fell_once = false;  ///< the force came down in one push only
    bool other_mode = false; ///< the modes of failure differ
};
/// @param slow a wall of level.audit
[[nodiscard]] AuditDifference audit_difference(const StudyLevel& level, const StudyWall& slow);

/// Walls of an audit beside the same walls of the study.
struct AuditDifferences {
    std::size_t checked = 0;            ///< both pushes gave a result
    std::size_t failed = 0;             ///< one of them did not
    std::size_t missing = 0;            ///< not run yet
    std::vector<double> peak, ultimate; ///< those that are defined, ascending [-]
    std::size_t fell_once = 0;          ///< walls whose force came down in one push only
    std::size_t other_modes = 0;        ///< walls whose mode is another
};
[[nodiscard]] AuditDifferences audit_differences(const StudyLevel& level);

/// The largest of few errors, or what 95 % of twenty or more lie below [-]; NaN without any.
/// @param sorted ascending
[[nodiscard]] double upper_error(const std::vector<double>& sorted);
/// Middle of the errors [-]; NaN without any.
[[nodiscard]] double median_error(const std::vector<double>& sorted);

/// "Solver error: median 0.1 %, 95 % of walls below 0.6 %, 2 of 50 walls above the 1 % asked
/// for (0.50 MPa sample 3, ...).", the error that it leaves in the ultimate displacement, the
/// error by contact points in the same words, and, of an audit, a further sentence. Says so
/// where the solver error is not known; empty where no wall gave a result.
[[nodiscard]] std::string solver_error_text(const StudyWalls& walls);

} // namespace app
