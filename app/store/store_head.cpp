#include "app/store/store_head.hpp"

#include "app/store/hdf5/store_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace app {

namespace {

constexpr const char* kNameCharacters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+()[]";

void require(bool good, const std::string& what)
{
    if (!good) throw std::invalid_argument("store: " + what);
}

void check_length(const char* what, const std::string& text, std::size_t most)
{
    require(text.size() <= most,
            std::string(what) + " has more than " + std::to_string(most) + " bytes");
}

void check_columns(const char* list, const std::vector<Column>& columns)
{
    std::set<std::string> names;
    for (const Column& column : columns) {
        const std::string& name = column.name;
        require(!name.empty() && name != "." && name != ".." && name.size() <= 200 &&
                    name.find_first_not_of(kNameCharacters) == std::string::npos,
                std::string(list) + ": column name '" + name +
                    "' must be of letters, digits and _-.+()[]");
        require(names.insert(name).second,
                std::string(list) + ": column '" + name + "' is there twice");
        check_length("a unit", column.unit, kMostTextBytes);
        check_length("a meaning", column.meaning, kMostTextBytes);
    }
}

void check_parts(const std::string& name, const StorePiers& parts)
{
    check_columns((name + "s").c_str(), parts.facts);
    require(parts.places.size() <= kMostPiers,
            "there must be at most " + std::to_string(kMostPiers) + " " + name + "s");
    for (const StorePier& p : parts.places)
        require(std::isfinite(p.from) && std::isfinite(p.to) && std::isfinite(p.bottom) &&
                    std::isfinite(p.top) && p.from < p.to && p.bottom < p.top,
                "a " + name + " must have a width and a height");
}

/// The levels of the other direction are those of the study with all their walls, those of an
/// audit with walls that it has.
void check_rounds(const StoreHead& head)
{
    const std::size_t own = own_levels(head), all = head.levels.size();
    const bool turned = own < all && head.levels[own].turned;
    require(own == all || all == 2 * own || (turned && all == 3 * own),
            "an audit, or the other direction, must have all levels of the study");
    for (std::size_t k = own; k < all; ++k) {
        const StoreLevel &level = head.levels[k], &of = head.levels[k % own];
        const bool other_way = turned && k < 2 * own;
        require(level.turned == other_way && (other_way == (level.slower == 1)) &&
                    level.vertical_stress == of.vertical_stress &&
                    (other_way ? level.samples == of.samples : level.samples <= of.samples),
                "level " + std::to_string(k) + " must be " +
                    (other_way ? "the walls of level " : "an audit of walls of level ") +
                    std::to_string(k % own) + (other_way ? " pushed the other way" : ""));
    }
    require(std::ranges::all_of(head.levels, [](const auto& l) { return l.slower >= 1; }),
            "levels must be pushed once or more times slower");
}

void check_sessions(const StoreHead& head)
{
    for (const StoreSession& s : head.sessions)
        for (const std::string* text :
             {&s.program_version, &s.machine, &s.build, &s.settings, &s.started})
            check_length("a session", *text, kMostTextBytes);
}

/// NaN is none.
bool is_sound(double v) { return std::abs(v) <= kMostSize; }

void check_sound(const WallRow& row, const std::vector<double>& values, const char* what)
{
    const auto bad = std::ranges::find_if_not(values, is_sound);
    if (bad != values.end())
        throw std::invalid_argument(wall_name(row.key) + ": " + what + " " +
                                    std::to_string(bad - values.begin() + 1) +
                                    " is not a finite number of at most 1e30");
}

} // namespace

Round round_of(const StoreLevel& level)
{
    return level.turned ? Round::turned : level.slower > 1 ? Round::audit : Round::own;
}

std::uint32_t own_levels(const StoreHead& head)
{
    const auto other = std::ranges::find_if(
        head.levels, [](const StoreLevel& level) { return round_of(level) != Round::own; });
    return static_cast<std::uint32_t>(other - head.levels.begin());
}

Round round_of(const StoreHead& head, WallKey key)
{
    return round_of(head.levels.at(key.level));
}

bool has_turned(const StoreHead& head)
{
    return std::ranges::any_of(head.levels, &StoreLevel::turned);
}

WallKey own_key(const StoreHead& head, WallKey key)
{
    if (round_of(head, key) != Round::own) key.level %= own_levels(head);
    return key;
}

std::uint64_t walls_wanted(const StoreHead& head)
{
    std::uint64_t walls = 0;
    for (const StoreLevel& level : head.levels) walls += level.samples;
    return walls;
}

std::uint32_t most_samples(const std::vector<StoreLevel>& levels)
{
    std::uint32_t most = 0;
    for (const StoreLevel& level : levels) most = std::max(most, level.samples);
    return most;
}

void check_head(const StoreHead& head)
{
    for (const StoreLevel& level : head.levels)
        require(std::isfinite(level.vertical_stress), "vertical stress must be finite");
    require(head.levels.size() <= 1'000'000, "levels must be at most 1000000");
    check_rounds(head);
    require(walls_wanted(head) <= kMostWalls, "has " + std::to_string(walls_wanted(head)) +
                                                  " walls; at most " +
                                                  std::to_string(kMostWalls) + " are possible");
    check_length("the configuration", head.configuration, kMostStudyBytes);
    check_length("the identity", head.identity, kMostStudyBytes);
    check_sessions(head);
    require(head.shards >= 1 && head.shard < head.shards,
            "shard " + std::to_string(head.shard) + " must be in [0, " +
                std::to_string(head.shards) + ")");
    require(std::ranges::adjacent_find(head.design_sizes, std::greater_equal{}) ==
                head.design_sizes.end(),
            "design sizes must increase");
    check_columns("inputs", head.inputs);
    check_columns("responses", head.responses);
    check_columns("counts", head.counts);
    check_columns("cost", head.cost);
    check_parts("pier", head.piers);
    check_parts("spandrel", head.spandrels);
}

void check_row(const StoreHead& head, const WallRow& row)
{
    const auto require_row = [&row](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument(wall_name(row.key) + ": " + what);
    };
    require_row(row.key.level < head.levels.size() &&
                    row.key.sample < head.levels[row.key.level].samples,
                "is not a wall of this study");
    require_row(row.reason.find('\0') == std::string::npos, "the reason must not hold a NUL");
    const auto length = [&](const char* list, std::size_t is, std::size_t wanted) {
        require_row(is == wanted, "there must be " + std::to_string(wanted) + " " + list +
                                      ", but there are " + std::to_string(is));
    };
    length("inputs", row.inputs.size(), head.inputs.size());
    length("responses", row.responses.size(), head.responses.size());
    length("counts", row.counts.size(), head.counts.size());
    length("cost", row.cost.size(), head.cost.size());
    length("forces of the curve", row.curve.force.size(), row.curve.displacement.size());
    require_row(row.curve.force.size() <= kMostPoints,
                "the curve has more than " + std::to_string(kMostPoints) + " points");
    const auto parts = [&](const std::string& name, const StorePiers& stored, const PierRow& is,
                           std::size_t points) {
        const std::size_t n = stored.places.size();
        length(("facts of " + name).c_str(), is.facts.size(), n * stored.facts.size());
        length(("movements of " + name).c_str(), is.movement.size(), n * points);
        length(("shears of " + name).c_str(), is.shear.size(), n * points);
        for (const auto* values : {&is.facts, &is.movement, &is.shear})
            require_row(std::ranges::none_of(
                            *values, [](double v) { return !std::isnan(v) && !is_sound(v); }),
                        "a number of " + name + " is not a finite number of at most 1e30");
    };
    parts("piers", head.piers, row.piers, row.curve.force.size());
    parts("spandrels", head.spandrels, row.spandrels, 0);
    check_sound(row, row.inputs, "input");
    if (row.status == kWallOk) {
        check_sound(row, row.curve.displacement, "displacement");
        check_sound(row, row.curve.force, "force");
    }
    const auto too_large = [](double v) {
        return std::isfinite(v) && std::abs(v) > std::numeric_limits<float>::max();
    };
    if (head.single_precision_curves)
        for (const auto* values : {&row.curve.displacement, &row.curve.force})
            require_row(std::ranges::none_of(*values, too_large),
                        "a value of the curve exceeds single precision");
}

} // namespace app
