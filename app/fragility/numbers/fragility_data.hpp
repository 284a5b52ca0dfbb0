#pragma once
/// Limit drifts of walls in groups (vertical stresses, or groups of a table): what fragility is
/// computed from, whoever ran the walls.

#include "app/fragility/numbers/tested_walls.hpp"
#include "app/output/table/table.hpp"
#include "app/reading/wall_reading.hpp"
#include "fragility/fits/censored_fit.hpp"
#include "fragility/fits/goodness_of_fit.hpp"
#include "fragility/fits/observation.hpp"
#include "fragility/laws/law.hpp"
#include "fragility/limits/limit_quantiles.hpp"
#include "fragility/limits/performance_limits.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct FragilityInput;
struct UqInput;
struct StudyWalls;

struct DriftWall {
    int mode = -1; ///< index in DriftData::modes; -1: no modes
    /// One per limit state [unit of the data]; nothing: not defined on this curve.
    std::vector<std::optional<fragility::Observation>> limits;
    /// A wall that misses the accuracy of its study may have limits that are so many times what
    /// was read, by the error of the solver; `most` may be infinite.
    double least = 1.0, most = 1.0;
    /// WallReading::governing: such a limit is no drift limit that is set, as it differs from
    /// wall to wall, and the error of the model does not concern it.
    std::vector<int> piers{};
};

/// A law fitted to limit drifts and its tests.
struct JudgedFit {
    fragility::Fit fit;
    fragility::GoodnessOfFit tests;
};

struct LimitDrifts {
    fragility::LimitQuantiles quantiles;
    fragility::PerformanceLimits law; ///< one law of all walls, whether it is used or not
    JudgedFit judged;                 ///< that law and its tests
};

struct DriftGroup {
    std::string name;             ///< "0.75 MPa"
    std::optional<double> stress; ///< [MPa]
    std::vector<DriftWall> walls; ///< that gave a result
    std::size_t failed = 0;       ///< ran and gave none
    std::size_t missing = 0;      ///< of the study, not in this file
    std::vector<JudgedFit>
        fits; ///< see app/fragility/numbers/drift_fits.hpp; empty: not judged yet
    std::vector<LimitDrifts>
        limits{};          ///< of each limit state, see limit_drifts.hpp; empty: not chosen yet
    AppliedFactor model{}; ///< error of the model, on every limit drift of the walls' own
};

/// How numbers are made of the data.
struct DriftOptions {
    fragility::Law law = fragility::Law::lognormal;
    double confidence = 0.95;     ///< in (0, 1)
    std::size_t bootstrap = 1000; ///< samples behind p-values; 0: none
    std::uint64_t seed = 1;       ///< of these
};
[[nodiscard]] DriftOptions drift_options(const UqInput& uq, const FragilityInput& fragility);

struct DriftData {
    std::string source;   ///< of captions: "paper.h5, 250 walls"
    std::string drift;    ///< what the drift is
    std::string no_limit; ///< why walls have no drift limit: a sentence; empty where they have
    std::string
        model_text; ///< the factor of the model, in sentences; empty: no walls of this program
    std::string unit = "%"; ///< of the drifts; empty: not said
    double percent = 1.0;   ///< drift in % per unit; 0: unknown
    std::string group_head; ///< of the first column: "stress [MPa]"
    std::vector<StateName> states;
    std::vector<std::string> modes; ///< "rocking", "mixed"
    std::vector<DriftGroup> groups;
    DriftOptions options;
};

/// Observations of one limit state: of all walls of a group, or of one mode.
[[nodiscard]] std::vector<fragility::Observation> limits_of(const DriftGroup& group,
                                                            std::size_t state, int mode = -1);

enum class ErrorEnd { least, most };
/// The same where the drift of every wall that misses the accuracy lies at this end of its
/// error; a drift limit that is set has no error. Quantiles of the drifts lie between those of
/// both ends.
[[nodiscard]] std::vector<fragility::Observation>
limits_at(const DriftGroup& group, std::size_t state, ErrorEnd end, int mode = -1);

/// Walls of `limits_of` that limits_at moves.
[[nodiscard]] std::size_t inaccurate_walls(const DriftGroup& group, std::size_t state);

/// Where a drift limit of a code or of the user comes first: "cap of the code (1.00 %): 100 %
/// of walls", "cap of the code (0.500 %): 20 % of walls, (1.00 %): 80 % of walls", with "; 3 of
/// 53 fell before" where walls did. Empty where it never does.
[[nodiscard]] std::string limit_text(const DriftData& data, std::size_t group,
                                     std::size_t state);

/// Piers whose drift limit comes first: "pier 3: 85 %, pier 4: 10 %" of the walls. Empty where
/// that of none does.
[[nodiscard]] std::string pier_text(const DriftData& data, std::size_t group,
                                    std::size_t state);

/// Whether every wall that reached the limit state reached such a limit: a row without any
/// number of the walls' own.
[[nodiscard]] bool only_limits(const std::vector<fragility::Observation>& limits);

/// "drift [%]", "drift" without unit
[[nodiscard]] std::string drift_head(const DriftData& data, const std::string& what);

/// A group in a table's first column: its stress, or its name.
[[nodiscard]] Cell group_cell(const DriftGroup& group);

/// "n walls gave a result, 2 failed, 10 not run; ..." of all groups, for captions.
[[nodiscard]] std::string counts_text(const DriftData& data);

/// Drifts in percent of the height of the load line.
[[nodiscard]] DriftData drift_data(const StudyWalls& walls);

} // namespace app
