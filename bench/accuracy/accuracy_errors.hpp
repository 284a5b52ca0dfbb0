#pragma once
/// Errors of pushes as asked against their references, and why some have none.

#include "bench/accuracy/accuracy_run.hpp"

#include <optional>
#include <string>
#include <vector>

namespace bench {

struct ComparedScene {
    AccuracyScene scene;
    std::string kinematics, fidelity;
    WallFacts facts;
    Answer asked, reference;
    std::optional<Answer> before; ///< of an earlier program
    std::string broken;           ///< what was thrown; empty: nothing
};

/// Whether there is a reference to compare with: it was not too dear and did not fail.
[[nodiscard]] bool has_reference(const ComparedScene& c);
/// Error of the peak force, signed [-]; nothing unless both have a peak.
[[nodiscard]] std::optional<double> peak_error(const ComparedScene& c);
/// One of both has a peak and the other none.
[[nodiscard]] bool is_lost(const ComparedScene& c);
/// Error of the first fall to 80 %, signed [-]; nothing unless both fall.
[[nodiscard]] std::optional<double> drop_error(const ComparedScene& c);
/// Both have a peak and only one of them falls to 80 % of it.
[[nodiscard]] bool is_branch(const ComparedScene& c);
/// The reported error is not smaller than the true one, or the true one is below kTooSmall.
[[nodiscard]] bool is_held(const ComparedScene& c);
/// The drop of the reference lies in the range that the push reports, or is missed by less than
/// kTooSmall; a wall that does not fall may fall beyond its push.
[[nodiscard]] bool is_drop_held(const ComparedScene& c);
inline constexpr double kTooSmall = 5e-4; ///< [-]; the reference itself is not known better

/// The value below or at which a share `p` of the values is; NaN of none.
[[nodiscard]] double quantile_of(std::vector<double> values, double p);

/// The scenes that an earlier program answered, with its answers in place of those of this one.
[[nodiscard]] std::vector<ComparedScene> as_before(const std::vector<ComparedScene>& scenes);

/// Remark on a scene beside its numbers; empty: nothing.
[[nodiscard]] std::string remark_on(const ComparedScene& scene);

} // namespace bench
