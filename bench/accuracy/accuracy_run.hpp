#pragma once
/// One scene of the accuracy campaign pushed as asked, and much more slowly as reference.

#include "bench/accuracy/accuracy_scene.hpp"
#include "dem/solver/push.hpp"

#include <optional>
#include <span>
#include <string>

namespace bench {

inline constexpr double kReferenceFactor = 20.0;

/// Settings that tell answers of one scene apart: the keys that set the speed of the drive.
[[nodiscard]] std::string speed_settings(const dem::SolverOptions& options);

/// The answer of one push.
struct Answer {
    std::string outcome;                 ///< dem::name, "came down at once", or "too dear"
    std::optional<double> peak, peak_at; ///< [N] [m]
    std::optional<double> drop;          ///< of the first fall to 80 % of the peak [m]
    /// Range of the drop as the push itself reports it [m]; no latest: beyond the push.
    std::optional<double> earliest, latest;
    double solver_error = 0.0; ///< as the push itself reports it [-]
    double residual = 0.0;     ///< of the energy [-]
    long long steps = 0;
    double seconds = 0.0; ///< of one core
};
inline constexpr const char* kTooDear = "too dear";

/// Pushes the wall of a study on this thread.
/// @param most_seconds of one core, after which it is given up as too dear
[[nodiscard]] Answer push_answer(const app::Study& study, const dem::SolverOptions& options,
                                 double most_seconds);

/// The study whose reference it is: what sets the speed of the drive is that of the scene,
/// whatever --set says.
[[nodiscard]] dem::SolverOptions reference_options(const app::Study& asked,
                                                   const app::Study& as_drawn);

struct WallFacts {
    double kn = 0.0;            ///< of the joints [Pa/m]
    double vertical_load = 0.0; ///< with the weight of the wall [N]
};
[[nodiscard]] WallFacts facts_of(const app::Study& study);

} // namespace bench
