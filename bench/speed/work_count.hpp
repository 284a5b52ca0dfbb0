#pragma once
/// Cost of one step of one wall in arithmetic and in memory traffic, counted from the tables
/// and the source, not measured.

#include "dem/solver/state/step_tables.hpp"

#include <cstddef>

namespace bench {

/// Operations on Reals of dem/solver/step/step.cpp and dem/contact/contact_law.hpp as written:
/// sums, products, multiply-adds, signs, comparisons and selections, one each. The path taken
/// by nearly all: combined damping, cracks that hold. tests/bench/test_work_count.cpp counts
/// them with a number that counts.
constexpr int kModeOperations = 29; ///< force, damping, motion and ledger of a mode
constexpr int kPortOperations = 2;  ///< what scatter adds up
constexpr int kDryOperations = 19;
constexpr int kTiedOperations = 3;
constexpr int kCrackOperations = 24;
constexpr int kDriveOperations = 2; ///< per row that moves with the beam
constexpr int kForceOperations = 1; ///< per row of beam or ground
constexpr int kStepOperations = 4;

struct StepWork {
    long long blocks = 0, modes = 0, ports = 0;
    long long dry = 0, tied = 0, cracks = 0; ///< contacts
    long long dry_laws = 0, crack_laws = 0;  ///< faces: each reads its law once
    long long multiply_adds = 0;             ///< of the port products, per wall
    long long operations = 0;                ///< all others, per wall
    long long matrix_bytes = 0;              ///< of the matrices of all elements
    [[nodiscard]] long long contacts() const { return dry + tied + cracks; }
};

[[nodiscard]] StepWork work_of(const dem::StepTables& tables);

/// Bytes that a step must move at least when each pass (blocks, then contacts) finds nothing of
/// the pass before in the first cache.
struct Traffic {
    double state = 0.0; ///< size of all that a step touches, matrices included
    double read = 0.0, written = 0.0;
    [[nodiscard]] double moved() const { return read + written; }
};

/// @param real bytes of a Real, all lanes
[[nodiscard]] Traffic traffic_of(const StepWork& work, std::size_t real);

} // namespace bench
