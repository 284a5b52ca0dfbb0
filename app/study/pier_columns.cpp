#include "app/study/pier_columns.hpp"

#include "app/input/wall_geometry.hpp"
#include "app/study/pier_reading.hpp"
#include "app/study/wall_openings.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();

/// A column and the field that it is.
struct Fact {
    const char* name;
    const char* unit;
    const char* meaning;
    double (*read)(const PierFacts&);
    void (*write)(PierFacts&, double);
};

// clang-format off
constexpr std::array kFacts = {
    Fact{"normal_before", "N", "compression before the push",
        [](const PierFacts& f) { return f.normal_before; }, [](PierFacts& f, double x) { f.normal_before = x; }},
    Fact{"normal_at_peak", "N", "compression when the wall carries most",
        [](const PierFacts& f) { return f.normal_at_peak; }, [](PierFacts& f, double x) { f.normal_at_peak = x; }},
    Fact{"shear_at_peak", "N", "when the wall carries most",
        [](const PierFacts& f) { return f.shear_at_peak; }, [](PierFacts& f, double x) { f.shear_at_peak = x; }},
    Fact{"largest_shear", "N", "in the push",
        [](const PierFacts& f) { return f.most_shear; }, [](PierFacts& f, double x) { f.most_shear = x; }},
    Fact{"end_movement", "m", "of its upper end against its lower end, at the end of the push",
        [](const PierFacts& f) { return f.end_movement; }, [](PierFacts& f, double x) { f.end_movement = x; }},
    Fact{"slenderness", "-", "H0/D, when the pier carries most",
        [](const PierFacts& f) { return f.slenderness; }, [](PierFacts& f, double x) { f.slenderness = x; }},
    Fact{"moved", "-", "1; 0: it stands still, and has no mode",
        [](const PierFacts& f) { return f.moved; }, [](PierFacts& f, double x) { f.moved = x; }},
    Fact{"rotation_share", "-", "as of a wall, over its own height",
        [](const PierFacts& f) { return f.mechanism.rotation_share; }, [](PierFacts& f, double x) { f.mechanism.rotation_share = x; }},
    Fact{"sliding_share", "-", "as of a wall, over its own height",
        [](const PierFacts& f) { return f.mechanism.sliding_share; }, [](PierFacts& f, double x) { f.mechanism.sliding_share = x; }},
    Fact{"turning_share", "-", "as of a wall, over its own height",
        [](const PierFacts& f) { return f.mechanism.turning_share; }, [](PierFacts& f, double x) { f.mechanism.turning_share = x; }},
    Fact{"cracked_units", "-", "units cracked through",
        [](const PierFacts& f) { return double{1} * f.mechanism.cracked_units; }, [](PierFacts& f, double x) { f.mechanism.cracked_units = static_cast<int>(x); }},
};
// clang-format on

} // namespace

StorePiers stored_piers_of(const Study& study)
{
    StorePiers stored;
    if (!tells_piers(study)) return stored;
    for (const dem::Pier& p : dem::piers_of(wall_openings(study), wall_extent(study)).piers)
        stored.places.push_back(
            {p.at.x0, p.at.x1, p.at.z0, p.at.z1, static_cast<std::uint32_t>(p.storey)});
    if (stored.places.empty()) return stored;
    for (const Fact& f : kFacts) stored.facts.push_back({f.name, f.unit, f.meaning});
    return stored;
}

PierRow pier_row(const PushedWall& wall, const StorePiers& piers)
{
    PierRow row;
    const std::size_t n = piers.places.size(), points = wall.displacement.size();
    if (n == 0) return row;
    const bool read = wall.piers.size() == n;
    for (const Fact& fact : kFacts)
        for (std::size_t p = 0; p < n; ++p)
            row.facts.push_back(read ? fact.read(wall.piers[p].facts) : kNotRead);
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
    for (const double x : row.facts)
        if (!std::isfinite(x)) return {};
    if (n == 0 || row.movement.size() < 2 * n) return {};
    std::vector<PierFacts> facts(n);
    for (std::size_t k = 0; k < piers.facts.size(); ++k)
        for (const Fact& fact : kFacts)
            if (fact.name == piers.facts[k].name)
                for (std::size_t p = 0; p < n; ++p) fact.write(facts[p], row.facts[k * n + p]);
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
