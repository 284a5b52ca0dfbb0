#pragma once
/// Head of a stored study: inputs, columns, origin.

#include "app/store/store_row.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace app {

constexpr std::size_t kMostTextBytes = 4096; ///< of a unit, a meaning, a text of a session
constexpr std::size_t kMostStudyBytes = 64u << 20; ///< of configuration and identity, each
constexpr std::uint64_t kMostWalls = 100'000'000;  ///< wanted at all levels
constexpr std::size_t kMostPoints = 4'000'000;     ///< of one curve; a study file allows 1e6
constexpr double kMostSize = 1e30; ///< of an input or a point of a curve: products stay finite

constexpr std::uint32_t kStoreLayout = 2; ///< counts up when the layout of FILE.h5 changes

/// Name, unit and meaning of one number of every wall. Names are unique in their list, not
/// empty, of letters, digits and "_-.+()[]" only, not "." or "..". Texts hold no NUL.
struct Column {
    std::string name;
    std::string unit; ///< "-" if it has none
    std::string meaning;
    friend bool operator==(const Column&, const Column&) = default;
};

struct StoreLevel {
    double vertical_stress = 0.0; ///< [Pa], finite
    std::uint32_t samples = 0;    ///< wanted: walls (level, 0 .. samples - 1)
    /// 1; more: a level of an audit, whose walls are pushed again so many times slower.
    std::uint32_t slower = 1;
    bool turned = false; ///< walls of a level before it, pushed the other way
    friend bool operator==(const StoreLevel&, const StoreLevel&) = default;
};

/// A pier or a spandrel of a wall with openings: where it is [m], and its storey, from 1 at the
/// bottom.
struct StorePier {
    double from = 0.0, to = 0.0, bottom = 0.0, top = 0.0;
    std::uint32_t storey = 1;
    friend bool operator==(const StorePier&, const StorePier&) = default;
};

/// Piers or spandrels that all walls of a study have, and the facts that are stored of each.
struct StorePiers {
    std::vector<StorePier> places; ///< empty: they are not told apart
    std::vector<Column> facts;
    friend bool operator==(const StorePiers&, const StorePiers&) = default;
};
constexpr std::size_t kMostPiers = 1000;

/// One process that added walls. Text only; differs between runs of the same study.
struct StoreSession {
    std::string program_version;
    std::string machine;         ///< host and processor
    std::string build;           ///< compiler and preset
    std::string settings;        ///< threads and what else moves no result
    std::string started;         ///< ISO 8601
    std::string solver_revision; ///< empty in files of before 0.2.0
    friend bool operator==(const StoreSession&, const StoreSession&) = default;
};

/// Begins the line of an identity that says which revision of the solver pushed the walls.
constexpr std::string_view kRevisionKey = "solver_revision = ";

struct StoreHead {
    std::string configuration; ///< complete effective study file
    std::string identity;      ///< all inputs that move results, one `key = value` per line
    std::vector<StoreLevel> levels;
    std::vector<std::uint32_t>
        design_sizes;       ///< sizes through which the design grew, increasing; kept by resume
    std::uint64_t seed = 0; ///< of the study
    std::uint32_t shard = 0, shards = 1; ///< this file holds part `shard` (from 0) of `shards`
    std::vector<Column> inputs, responses, counts, cost;
    bool single_precision_curves = false; ///< curves are rounded to float when a wall is added
    std::vector<StoreSession> sessions;   ///< oldest first
    StorePiers piers{}, spandrels{};      ///< of files of before 0.4.0 no spandrels
    friend bool operator==(const StoreHead&, const StoreHead&) = default;
};

/// The reason for which the walls of a level are pushed.
enum class Round {
    own,    ///< the study
    turned, ///< the other direction
    audit   ///< the same, more slowly
};
[[nodiscard]] Round round_of(const StoreLevel& level);

/// Number of the study's own levels. A study of both directions has as many again after them,
/// in the same order: wall (own_levels + k, i) is wall (k, i) pushed the other way. A study
/// with an audit has as many again at the end.
[[nodiscard]] std::uint32_t own_levels(const StoreHead& head);
[[nodiscard]] Round round_of(const StoreHead& head, WallKey key);
[[nodiscard]] inline bool is_audit(const StoreHead& head, WallKey key)
{
    return round_of(head, key) == Round::audit;
}
/// Whether walls are pushed both ways.
[[nodiscard]] bool has_turned(const StoreHead& head);
/// The wall of the study that a wall is, or is pushed again for.
[[nodiscard]] WallKey own_key(const StoreHead& head, WallKey key);

/// Throws std::invalid_argument naming the field and what is allowed.
void check_head(const StoreHead& head);
/// Throws std::invalid_argument naming the wall and what does not fit the head. Inputs, and the
/// curve of a wall that is ok, hold finite numbers of at most kMostSize.
void check_row(const StoreHead& head, const WallRow& row);

[[nodiscard]] std::uint64_t walls_wanted(const StoreHead& head);
/// Largest number of samples of a level, 0 without levels.
[[nodiscard]] std::uint32_t most_samples(const std::vector<StoreLevel>& levels);

} // namespace app
