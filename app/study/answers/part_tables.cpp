#include "app/study/answers/part_tables.hpp"

#include "app/output/table/cells.hpp"
#include "app/output/table/table_columns.hpp"
#include "app/study/answers/mean_cells.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/pier_reading.hpp"
#include "app/study/pushed/pier_remark.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace app {
namespace {

/// A pier or spandrel in all walls of a level that were pushed to one side.
template <class Place, class Part> struct PartOfWalls {
    double stress;
    int direction;
    std::size_t place;
    const Place* part;
    std::vector<Part> walls;
};
using PierOfWalls = PartOfWalls<dem::Pier, StudyPier>;
using SpandrelOfWalls = PartOfWalls<dem::Spandrel, SpandrelReading>;

/// A number of each wall, shown as `scale` times its median.
template <class Of, class Value>
TableColumn<Of> median_column(Head head, int decimals, double scale, Value value)
{
    return {std::move(head), [=](const Of& r) {
                std::vector<double> values;
                for (const auto& p : r.walls) values.push_back(scale * value(p));
                return median_number(std::move(values), decimals);
            }};
}

/// @param is whether a mode_text() counts
template <class Is> TableColumn<PierOfWalls> share_column(Head head, Is is)
{
    return {std::move(head), [is](const PierOfWalls& r) {
                if (r.walls.empty()) return Number{};
                const auto with =
                    static_cast<double>(std::ranges::count_if(r.walls, is, &StudyPier::mode));
                return plain_number(100.0 * with / static_cast<double>(r.walls.size()), 0);
            }};
}

TableColumn<PierOfWalls> mode_column(const std::string& mode, unsigned holds)
{
    return share_column({mode + " [%]", holds},
                        [mode](std::string_view text) { return text == mode; });
}

/// Every part at every stress, to the direction of the study and to the other.
template <class Place, class Part>
std::vector<PartOfWalls<Place, Part>>
parts_of(const StudyWalls& study, const std::vector<Place>& places,
         std::vector<Part> StudyWall::*own, std::vector<Part> StudyWall::*turned)
{
    const int direction = study.rules.direction;
    std::vector<std::pair<int, std::vector<Part> StudyWall::*>> sides = {{direction, own}};
    if (has_turned(study.head)) sides.emplace_back(-direction, turned);
    std::vector<PartOfWalls<Place, Part>> all;
    for (const StudyLevel& level : study.levels)
        for (const auto& [way, parts] : sides)
            for (std::size_t p = 0; p < places.size(); ++p) {
                PartOfWalls<Place, Part> r{level.stress, way, p, &places[p], {}};
                for (const StudyWall& w : level.walls)
                    if (!(w.*parts).empty()) r.walls.push_back((w.*parts).at(p));
                all.push_back(std::move(r));
            }
    return all;
}

/// Stress, direction and number stand before every row.
template <class Of> TableColumns<Of> keys_of(const char* part)
{
    return {{"stress [MPa]", [](const Of& r) { return stress_cell(r.stress); }},
            {"pushed to the", [](const Of& r) { return std::string(way_name(r.direction)); }},
            {part, [](const Of& r) { return count(r.place + 1); }}};
}

/// Where it is, and of how many walls its numbers are.
template <class Of> TableColumns<Of> places_of()
{
    const auto side = [](const char* head, double dem::Region::*of) {
        return TableColumn<Of>{{head, kDetail},
                               [of](const Of& r) { return plain_number(r.part->at.*of, 2); }};
    };
    return {side("from [m]", &dem::Region::x0),
            side("to [m]", &dem::Region::x1),
            {{"height [m]", kDetail},
             [](const Of& r) { return plain_number(r.part->at.z1 - r.part->at.z0, 2); }},
            {{"n", kDetail}, [](const Of& r) { return count(r.walls.size()); }}};
}

} // namespace

Table study_pier_table(const StudyWalls& study)
{
    using Of = PierOfWalls;
    using Pier = const StudyPier&;
    Table t;
    t.title = "Piers";
    t.caption = "Medians over the walls. " + std::string(kPierNumbers) +
                " Shares of the walls in which it fails so; 'keeps its shear': it had not come "
                "down when the push ended; 'carries little': never 5 % of the wall's force, "
                "such a pier governs nothing.";
    t.keys = 3;
    TableColumns<Of> columns = keys_of<Of>("pier");
    columns.push_back({{"storey", kDetail}, [](const Of& r) { return count(r.part->storey); }});
    append(columns, places_of<Of>());
    append(columns,
           {median_column<Of>("N [kN]", 1, 1e-3, [](Pier p) { return p.normal; }),
            median_column<Of>("V [kN]", 1, 1e-3, [](Pier p) { return p.shear; }),
            median_column<Of>("drift [%]", 2, 100.0, [](Pier p) { return p.drift; }),
            median_column<Of>({"H0/D", kDetail}, 2, 1.0, [](Pier p) { return p.slenderness; }),
            mode_column("rocking", 0), mode_column("sliding", 0), mode_column("mixed", 0),
            share_column("keeps its shear [%]", is_so_far),
            mode_column("carries little", kDetail), mode_column("stands still", kDetail)});
    fill(t, columns, parts_of(study, study.piers, &StudyWall::piers, &StudyWall::turned_piers));
    return t;
}

Table study_spandrel_table(const StudyWalls& study)
{
    using Of = SpandrelOfWalls;
    using Spandrel = const SpandrelReading&;
    Table t;
    t.title = "Spandrels";
    t.caption = "Medians over the walls. " + std::string(kSpandrelNumbers);
    t.keys = 3;
    TableColumns<Of> columns = keys_of<Of>("spandrel");
    append(columns, places_of<Of>());
    append(
        columns,
        {median_column<Of>("N [kN]", 1, 1e-3,
                           [](Spandrel s) { return s.facts.normal_at_peak; }),
         median_column<Of>("V [kN]", 1, 1e-3, [](Spandrel s) { return s.facts.shear_at_peak; }),
         median_column<Of>("largest V [kN]", 1, 1e-3,
                           [](Spandrel s) { return s.facts.most_shear; }),
         median_column<Of>("drift [%]", 3, 100.0, [](Spandrel s) { return s.drift; })});
    fill(t, columns,
         parts_of(study, study.spandrels, &StudyWall::spandrels, &StudyWall::turned_spandrels));
    return t;
}

} // namespace app
