#include "app/study/pushed/pier_columns.hpp"

#include "app/input/wall/wall_geometry.hpp"
#include "app/study/pushed/pier_reading.hpp"
#include "app/study/pushed/wall_openings.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();

/// A column and the field that it is.
template <class Facts> struct Fact {
    const char* name;
    const char* unit;
    const char* meaning;
    double (*read)(const Facts&);
    void (*write)(Facts&, double);
};
using PierFact = Fact<PierFacts>;
using SpandrelFact = Fact<SpandrelFacts>;

// clang-format off
constexpr std::array kFacts = {
    PierFact{"normal_before", "N", "compression before the push",
        [](const PierFacts& f) { return f.normal_before; }, [](PierFacts& f, double x) { f.normal_before = x; }},
    PierFact{"normal_at_peak", "N", "compression when the wall carries most",
        [](const PierFacts& f) { return f.normal_at_peak; }, [](PierFacts& f, double x) { f.normal_at_peak = x; }},
    PierFact{"shear_at_peak", "N", "when the wall carries most",
        [](const PierFacts& f) { return f.shear_at_peak; }, [](PierFacts& f, double x) { f.shear_at_peak = x; }},
    PierFact{"largest_shear", "N", "in the push",
        [](const PierFacts& f) { return f.most_shear; }, [](PierFacts& f, double x) { f.most_shear = x; }},
    PierFact{"end_movement", "m", "of its upper end against its lower end, at the end of the push",
        [](const PierFacts& f) { return f.end_movement; }, [](PierFacts& f, double x) { f.end_movement = x; }},
    PierFact{"slenderness", "-", "H0/D, when the pier carries most",
        [](const PierFacts& f) { return f.slenderness; }, [](PierFacts& f, double x) { f.slenderness = x; }},
    PierFact{"moved", "-", "1; 0: it stands still, and has no mode",
        [](const PierFacts& f) { return f.moved; }, [](PierFacts& f, double x) { f.moved = x; }},
    PierFact{"rotation_share", "-", "as of a wall, over its own height",
        [](const PierFacts& f) { return f.mechanism.rotation_share; }, [](PierFacts& f, double x) { f.mechanism.rotation_share = x; }},
    PierFact{"sliding_share", "-", "as of a wall, over its own height",
        [](const PierFacts& f) { return f.mechanism.sliding_share; }, [](PierFacts& f, double x) { f.mechanism.sliding_share = x; }},
    PierFact{"turning_share", "-", "as of a wall, over its own height",
        [](const PierFacts& f) { return f.mechanism.turning_share; }, [](PierFacts& f, double x) { f.mechanism.turning_share = x; }},
    PierFact{"cracked_units", "-", "units cracked through",
        [](const PierFacts& f) { return double{1} * f.mechanism.cracked_units; }, [](PierFacts& f, double x) { f.mechanism.cracked_units = static_cast<int>(x); }},
};
constexpr std::array kSpandrelFacts = {
    SpandrelFact{"normal_at_peak", "N", "compression along the wall, in the middle of the opening, when the wall carries most",
        [](const SpandrelFacts& f) { return f.normal_at_peak; }, [](SpandrelFacts& f, double x) { f.normal_at_peak = x; }},
    SpandrelFact{"shear_at_peak", "N", "by how much its right half presses its left half down, when the wall carries most",
        [](const SpandrelFacts& f) { return f.shear_at_peak; }, [](SpandrelFacts& f, double x) { f.shear_at_peak = x; }},
    SpandrelFact{"largest_shear", "N", "in the push, in either sense",
        [](const SpandrelFacts& f) { return f.most_shear; }, [](SpandrelFacts& f, double x) { f.most_shear = x; }},
    SpandrelFact{"end_drop", "m", "of its right end against its left end, downwards, at the end of the push",
        [](const SpandrelFacts& f) { return f.end_drop; }, [](SpandrelFacts& f, double x) { f.end_drop = x; }},
};
// clang-format on

StorePier place_of(const dem::Region& at, int storey)
{
    return {at.x0, at.x1, at.z0, at.z1, static_cast<std::uint32_t>(storey)};
}

template <class Facts, std::size_t N>
void add_columns(StorePiers& stored, const std::array<Fact<Facts>, N>& columns)
{
    if (stored.places.empty()) return;
    for (const Fact<Facts>& f : columns) stored.facts.push_back({f.name, f.unit, f.meaning});
}

/// Facts of all parts of a wall, by part within a fact; NaN where nothing was read of them.
template <class Reading, class Facts, std::size_t N>
std::vector<double> facts_row(const std::vector<Reading>& parts, std::size_t n,
                              const std::array<Fact<Facts>, N>& columns)
{
    std::vector<double> row;
    for (const Fact<Facts>& fact : columns)
        for (std::size_t p = 0; p < n; ++p)
            row.push_back(parts.size() == n ? fact.read(parts[p].facts) : kNotRead);
    return row;
}

/// The same back; nothing where nothing was read.
template <class Facts, std::size_t N>
std::vector<Facts> facts_of(const PierRow& row, const StorePiers& stored,
                            const std::array<Fact<Facts>, N>& columns)
{
    const std::size_t n = stored.places.size();
    for (const double x : row.facts)
        if (!std::isfinite(x)) return {};
    std::vector<Facts> facts(n);
    for (std::size_t k = 0; k < stored.facts.size(); ++k)
        for (const Fact<Facts>& fact : columns)
            if (fact.name == stored.facts[k].name)
                for (std::size_t p = 0; p < n; ++p) fact.write(facts[p], row.facts[k * n + p]);
    return facts;
}

} // namespace

StorePiers stored_piers_of(const Masonry& masonry, const LoadInput& load)
{
    StorePiers stored;
    if (!tells_piers(masonry, load)) return stored;
    for (const dem::Pier& p : dem::piers_of(wall_openings(masonry), wall_extent(masonry)).piers)
        stored.places.push_back(place_of(p.at, p.storey));
    add_columns(stored, kFacts);
    return stored;
}

StorePiers stored_spandrels_of(const Masonry& masonry, const LoadInput& load)
{
    StorePiers stored;
    if (!tells_piers(masonry, load)) return stored;
    for (const dem::Spandrel& s :
         dem::piers_of(wall_openings(masonry), wall_extent(masonry)).spandrels)
        stored.places.push_back(place_of(s.at, 1));
    add_columns(stored, kSpandrelFacts);
    return stored;
}

PierRow spandrel_row(const PushedWall& wall, const StorePiers& spandrels)
{
    return {facts_row(wall.spandrels, spandrels.places.size(), kSpandrelFacts), {}, {}};
}

std::vector<SpandrelFacts> spandrel_facts_of(const PierRow& row, const StorePiers& spandrels)
{
    return facts_of(row, spandrels, kSpandrelFacts);
}

std::vector<dem::Spandrel> spandrels_of(const StorePiers& spandrels)
{
    std::vector<dem::Spandrel> all;
    for (const StorePier& s : spandrels.places)
        all.push_back({{s.from, s.bottom, s.to, s.top}, 0.5 * (s.from + s.to)});
    return all;
}

PierRow pier_row(const PushedWall& wall, const StorePiers& piers)
{
    PierRow row;
    const std::size_t n = piers.places.size(), points = wall.displacement.size();
    if (n == 0) return row;
    const bool read = wall.piers.size() == n;
    row.facts = facts_row(wall.piers, n, kFacts);
    for (std::size_t k = 0; k < points; ++k)
        for (std::size_t p = 0; p < n; ++p) {
            row.movement.push_back(read ? wall.piers[p].facts.movement[k] : kNotRead);
            row.shear.push_back(read ? wall.piers[p].facts.shear[k] : kNotRead);
        }
    return row;
}

std::vector<PierFacts> pier_facts_of(const PierRow& row, const StorePiers& piers)
{
    const std::size_t n = piers.places.size();
    if (n == 0 || row.movement.size() < 2 * n) return {};
    std::vector<PierFacts> facts = facts_of(row, piers, kFacts);
    if (facts.empty()) return facts;
    for (std::size_t i = 0; i < row.movement.size(); ++i) {
        if (!std::isfinite(row.movement[i]) || !std::isfinite(row.shear[i])) return {};
        facts[i % n].movement.push_back(row.movement[i]);
        facts[i % n].shear.push_back(row.shear[i]);
    }
    return facts;
}

std::vector<dem::Pier> piers_of(const StorePiers& piers)
{
    std::vector<dem::Pier> all;
    for (const StorePier& p : piers.places)
        all.push_back({{p.from, p.bottom, p.to, p.top}, 0.0, static_cast<int>(p.storey)});
    return all;
}

} // namespace app
