#pragma once
/// The one table of the numbers of a wall. A row is a column of the file of a study, an output
/// of a server, a key of summary.json, a column of tables, an array in Python and a line of
/// docs/numbers.md; the first rows are words of reliability.response and uq.stop, too.

#include "app/reading/wall_reading.hpp"
#include "dem/solver/push.hpp"
#include "fragility/curve/drift.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

namespace app {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// Data that the numbers of a wall are taken from.
struct WallSource {
    const WallReading& reading;
    double height; ///< of the load line [m], > 0
    const dem::Mechanism& mechanism;
    double solver_error = kNoNumber;         ///< [-]
    double points_error = kNoNumber;         ///< [-]
    double last_displacement = kNoNumber;    ///< of the curve [m]
    const dem::PushResult* result = nullptr; ///< null: the wall comes from a file

    /// @throws std::logic_error for a wall from a file
    [[nodiscard]] const dem::PushResult& run() const
    {
        if (result == nullptr) throw std::logic_error("a number of a push, asked of a file");
        return *result;
    }
};

/// Unit in which people and summary.json get a number; programs get SI elsewhere.
struct ShownUnit {
    std::string_view name; ///< "kN"
    std::string_view si;   ///< "N"
    double scale;          ///< shown value / value in SI
};

inline constexpr ShownUnit kForceUnit{"kN", "N", 1e-3}, kLengthUnit{"mm", "m", 1e3},
    kStiffnessUnit{"kN/mm", "N/m", 1e-6}, kPercent{"%", "-", 1e2}, kEnergyUnit{"J", "J", 1.0},
    kAreaUnit{"mm2", "m2", 1e6}, kNoUnit{"-", "-", 1.0};

/// How the file of a study keeps a number. A reading that is kept follows from the curve alone.
enum class Kept { no, as_response, as_count };

using ReadOff = double (*)(const WallReading& wall, double height);
using ReadFact = double (*)(const WallSource& wall);
using IsBound = bool (*)(const WallReading& wall);

struct WallNumber {
    std::string_view name; ///< "peak_force"
    std::string_view head; ///< of a column of a table: "peak"; empty: the words of the name
    ShownUnit unit;
    int decimals; ///< shown
    Kept kept;
    std::string_view meaning;
    /// A reading follows the rules of [fragility], a fact does not; one of both is null. In SI,
    /// of a reading the bound where only that is known; NaN: not defined on this wall.
    ReadOff reading = nullptr;
    ReadFact fact = nullptr;
    /// Whether the push ended before the reading was reached; null: it has no bound.
    IsBound is_bound = nullptr;
    bool ends_with_push = false; ///< a push that ends before can only say that it is larger
    std::string_view old_key{};  ///< of summary.json until version 0.2
};

constexpr WallNumber fact_of(std::string_view name, ShownUnit unit, int decimals,
                             std::string_view meaning, ReadFact fact,
                             std::string_view old_key = {})
{
    return {name, "",      unit,  decimals, Kept::as_response, meaning, nullptr,
            fact, nullptr, false, old_key};
}

constexpr WallNumber count_fact(std::string_view name, Kept kept, std::string_view meaning,
                                ReadFact fact)
{
    return {name, "", kNoUnit, 0, kept, meaning, nullptr, fact};
}

constexpr double displacement_of(const fragility::LimitDisplacement& limit)
{
    return is_defined(limit) ? limit.displacement : kNoNumber;
}

inline bool still_rising(const WallReading& w) { return w.peak && w.peak->at_end; }
inline bool never_fell(const WallReading& w) { return is_censored(w.ultimate); }
inline bool ends_in_range(const WallReading& w) { return is_censored(w.ultimate_range.latest); }
inline bool never_collapsed(const WallReading& w) { return is_censored(w.collapse); }

// clang-format off
inline constexpr std::array kWallNumbers = {
    WallNumber{"peak_force", "peak", kForceUnit, 2, Kept::as_response, "largest horizontal load",
        [](const WallReading& w, double) { return peak_force(w); }, nullptr, still_rising},
    WallNumber{"peak_displacement", "at peak", kLengthUnit, 2, Kept::as_response, "of the load line at the first largest load",
        [](const WallReading& w, double) { return peak_displacement(w); }, nullptr, still_rising, true, "displacement_at_peak_mm"},
    WallNumber{"ultimate_displacement", "ultimate", kLengthUnit, 2, Kept::no, "of the load line where the force is down to fragility.ultimate_share of the peak",
        [](const WallReading& w, double) { return displacement_of(w.ultimate); }, nullptr, never_fell, true},
    WallNumber{"ultimate_drift", "drift", kPercent, 2, Kept::no, "ultimate displacement over the height of the load line",
        [](const WallReading& w, double height) { return fragility::drift(displacement_of(w.ultimate), height); }, nullptr, never_fell, true},
    WallNumber{"ultimate_censored", "", kNoUnit, 0, Kept::no, "1: the ultimate displacement is only a lower bound",
        [](const WallReading& w, double) { return never_fell(w) ? 1.0 : 0.0; }},
    WallNumber{"ultimate_error", "", kPercent, 2, Kept::no, "error of the ultimate displacement, if the peak force is wrong by its solver error, and at least twice the accuracy asked: the farther end of its range; a wall may still fall on another branch",
        [](const WallReading& w, double) { return ultimate_error(w); }, nullptr, ends_in_range},
    WallNumber{"collapse_displacement", "", kLengthUnit, 2, Kept::no, "of the load line where no force is left or the wall came down",
        [](const WallReading& w, double) { return displacement_of(w.collapse); }, nullptr, never_collapsed, true},
    WallNumber{"secant_stiffness", "stiffness", kStiffnessUnit, 1, Kept::as_response, "at 30 % of the peak",
        [](const WallReading& w, double) { return w.stiffness.value_or(kNoNumber); }, nullptr, nullptr, false, "stiffness_kN_per_mm"},
    fact_of("last_displacement", kLengthUnit, 2, "where the curve ends", [](const WallSource& w) { return w.last_displacement; }),
    fact_of("settlement", kLengthUnit, 2, "of the beam under vertical load alone, positive down",
        [](const WallSource& w) { return dem::failed(w.run().outcome) ? kNoNumber : w.run().settlement; }),
    fact_of("rotation_share", kNoUnit, 2, "rotation of the beam x height / displacement: 1 for pure rocking; like the two columns of cracks at the end; with finite displacements where the force came down to fragility.ultimate_share, or, where it did not, of the movement since half of the way",
        [](const WallSource& w) { return w.mechanism.rotation_share; }),
    fact_of("sliding_share", kNoUnit, 2, "slip of the closed bed joints, summed over the courses / displacement",
        [](const WallSource& w) { return w.mechanism.sliding_share; }),
    fact_of("turning_share", kNoUnit, 2, "rotation of the blocks x height / displacement: 1 too for piers that rock and for a wall in double bending; to either side in an arch on its hinges",
        [](const WallSource& w) { return w.mechanism.turning_share; }),
    fact_of("work", kEnergyUnit, 2, "of all loads, at the end", [](const WallSource& w) { return w.run().energy.work; }),
    fact_of("elastic_energy", kEnergyUnit, 2, "of blocks and contacts, at the end", [](const WallSource& w) { return w.run().energy.elastic; }),
    fact_of("friction_energy", kEnergyUnit, 2, "lost in slip", [](const WallSource& w) { return w.run().energy.friction; }),
    fact_of("fracture_energy", kEnergyUnit, 2, "lost in cracks of units", [](const WallSource& w) { return w.run().energy.fracture; }),
    fact_of("crushing_energy", kEnergyUnit, 2, "lost in contacts that crush", [](const WallSource& w) { return w.run().energy.crushing; }),
    fact_of("crushed_area", kAreaUnit, 0, "of contacts that have lost all their compressive strength",
        [](const WallSource& w) { return w.mechanism.crushed_area; }, "crushed_through_mm2"),
    fact_of("energy_residual", kPercent, 4, "largest share of the work that the ledger misses, anywhere",
        [](const WallSource& w) { return w.run().outcome == dem::Outcome::not_finite ? kNoNumber : w.run().residual; }),
    fact_of("solver_error", kPercent, 2, "estimated error of the peak force by the speed of the drive", [](const WallSource& w) { return w.solver_error; }),
    fact_of("points_error", kPercent, 2, "estimated error of the force by the number of contact points, over the peak: the larger of that at the peak and that later", [](const WallSource& w) { return w.points_error; }),
    fact_of("step_fraction", kNoUnit, 2, "step used, of the proven stable one", [](const WallSource& w) { return w.run().step_fraction; }),
    count_fact("outcome", Kept::as_count, "", [](const WallSource& w) { return static_cast<double>(w.run().outcome); }),
    count_fact("cracked_units", Kept::as_count, "units cracked through", [](const WallSource& w) { return double(w.mechanism.cracked_units); }),
    count_fact("cracked_contacts", Kept::as_count, "contact points in units with D = 1", [](const WallSource& w) { return double(w.mechanism.cracked_contacts); }),
    count_fact("spalled_units", Kept::as_count, "units that have lost parts smaller than a quarter", [](const WallSource& w) { return double(w.mechanism.spalled_units); }),
    count_fact("crushed_contacts", Kept::as_count, "contact points of joints and units that have begun to crush", [](const WallSource& w) { return double(w.mechanism.crushed_contacts); }),
    count_fact("brittle_crushing_contacts", Kept::no, "contact points that crush at once", [](const WallSource& w) { return double(w.run().brittle_crushing_contacts); }),
    count_fact("snap_back_contacts", Kept::as_count, "in units, that break at once", [](const WallSource& w) { return double(w.run().snap_back_contacts); }),
    count_fact("shear_snap_back_contacts", Kept::no, "in units, that break at their first slip", [](const WallSource& w) { return double(w.run().shear_snap_back_contacts); }),
    count_fact("crack_contacts", Kept::no, "contact points of cracks in units and of joints with mortar", [](const WallSource& w) { return double(w.run().crack_contacts); }),
    count_fact("contacts_softened_in_tension", Kept::no, "crack contacts that have lost a part of their tensile strength", [](const WallSource& w) { return double(w.run().softened_in_tension); }),
    count_fact("contacts_softened_in_shear", Kept::no, "crack contacts that have lost a part of their cohesion", [](const WallSource& w) { return double(w.run().softened_in_shear); }),
    count_fact("settled", Kept::as_count, "1: at rest under the vertical load before the push", [](const WallSource& w) { return double(w.run().settled); }),
    count_fact("step_reductions", Kept::as_count, "times the step was halved", [](const WallSource& w) { return double(w.run().step_reductions); }),
    count_fact("slow_starts", Kept::no, "starts in ten times the steps", [](const WallSource& w) { return double(w.run().slow_starts); }),
    count_fact("slowdowns", Kept::no, "times the wall was pushed again, twice as slowly", [](const WallSource& w) { return double(w.run().slowdowns); }),
    count_fact("steps", Kept::as_count, "of the solver, those of steps given up included", [](const WallSource& w) { return double(w.run().cost.steps); }),
    count_fact("contact_updates", Kept::no, "of the solver", [](const WallSource& w) { return double(w.run().cost.contact_updates); }),
};
// clang-format on

/// Rows that a study can be judged by: words of reliability.response and uq.stop.
constexpr std::size_t kJudged = 4;

/// The row of this name; the compiler refuses others.
consteval const WallNumber& wall_number(std::string_view name)
{
    for (const WallNumber& n : kWallNumbers)
        if (n.name == name) return n;
    throw std::logic_error("no number of a wall has this name");
}

/// In SI; NaN: not defined on this wall.
[[nodiscard]] inline double value(const WallNumber& n, const WallSource& wall)
{
    return n.reading != nullptr ? n.reading(wall.reading, wall.height) : n.fact(wall);
}

/// With the names of all outcomes.
[[nodiscard]] std::string meaning(const WallNumber& number);

/// "peak force"
[[nodiscard]] std::string words(const WallNumber& number);

/// Head of a column of a table: "peak [kN]".
[[nodiscard]] std::string head_text(const WallNumber& number);

/// Name in summary.json: "peak_force_kN", "solver_error_percent", "steps".
[[nodiscard]] std::string summary_key(const WallNumber& number);

/// docs/numbers.md
[[nodiscard]] std::string numbers_page();

} // namespace app
