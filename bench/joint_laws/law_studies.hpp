#pragma once
/// Studies that bench/joint_laws.sh leaves, and what is read off their walls.

#include "app/study/stored/study_walls.hpp"
#include "fragility/fits/kaplan_meier.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bench {

/// Work of the walls of one stress, failed ones included.
struct LevelCost {
    double steps = 0.0, seconds = 0.0; ///< of the solver; seconds of one core
    double residual = 0.0;             ///< largest share of the work that a ledger misses [-]
};

struct LawStudy {
    app::StudyWalls walls;
    std::vector<LevelCost> costs; ///< one per stress
};

/// Studies of a folder. Those that are not there, and stresses that are not run to the end, are
/// left out and noted.
class LawStudies {
  public:
    explicit LawStudies(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Nothing: there is no such file, or no stress of it is complete.
    /// @param name "mean/paper"
    /// @throws app::StoreError if the file cannot be read
    [[nodiscard]] std::optional<LawStudy> read(const std::string& name);

    [[nodiscard]] const std::vector<std::string>& missing() const { return missing_; }

  private:
    void note_missing(const std::string& what);

    std::filesystem::path folder_;
    std::vector<std::string> missing_;
};

/// Limit drifts [%] of the walls of a stress: where they came down to 80 % of their peak
/// (Kaplan and Meier).
[[nodiscard]] fragility::KaplanMeier limit_drifts(const LawStudy& study, std::size_t level);

/// Drift [%] at which a share of walls has come down; nothing if it never does.
[[nodiscard]] std::optional<double> quantile(const fragility::KaplanMeier& drifts,
                                             double share);

/// Walls that came down to 80 % of their peak within a drift [%], of those of which it is
/// known.
struct WallsWithin {
    std::size_t down = 0, known = 0;
};
[[nodiscard]] WallsWithin walls_within(const LawStudy& study, std::size_t level, double drift);

/// Mean peak force [kN]; NaN without walls.
[[nodiscard]] double mean_peak(const LawStudy& study, std::size_t level);

/// Secant of the wall's own curve where it first reaches a share of its peak [kN/mm].
[[nodiscard]] std::optional<double> secant(const LawStudy& study, const app::StudyWall& wall,
                                           double share);

/// The stress of `study` that is `stress` [Pa]; nothing if it has none.
[[nodiscard]] std::optional<std::size_t> level_at(const LawStudy& study, double stress);

} // namespace bench
