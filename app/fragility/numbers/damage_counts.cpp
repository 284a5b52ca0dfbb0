#include "app/fragility/numbers/damage_counts.hpp"

#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace app {
namespace {

constexpr double kMostDamageStates = 20;
constexpr double kMostWalls = 1e9; ///< of a row

/// How many walls.
double walls_at(const Csv& csv, const CsvRow& row, std::size_t column)
{
    const double n = number_at(csv, row, column);
    if (n > kMostWalls)
        refuse_cell(csv, row, column,
                    number(n, 12) + " is more than " + number(kMostWalls, 12) +
                        "; write a number of walls");
    return n;
}

/// Walls in each state of a row, from the numbers that reached it or a severer one.
std::vector<double> from_failed(const Csv& csv, const CsvRow& row, std::size_t of,
                                const std::vector<std::size_t>& failed)
{
    std::vector<double> walls;
    double before = walls_at(csv, row, of);
    std::size_t column = of;
    for (const std::size_t c : failed) {
        const double n = number_at(csv, row, c);
        if (n > before)
            refuse_cell(csv, row, c,
                        number(n, 12) + " is more than " + number(before, 12) + " in column " +
                            in_quotes(csv.head[column]) +
                            (column == of ? "" : ", the milder state"));
        walls.push_back(before - n);
        before = n;
        column = c;
    }
    walls.push_back(before);
    return walls;
}

std::vector<double> from_state(const Csv& csv, const CsvRow& row, std::size_t state, double n)
{
    const double k = number_at(csv, row, state);
    if (k != std::floor(k) || k > kMostDamageStates)
        refuse_cell(csv, row, state,
                    number(k, 12) +
                        " is not a damage state; write 0 for none, 1, 2, ... up to " +
                        number(kMostDamageStates, 12));
    std::vector<double> walls(static_cast<std::size_t>(k) + 1, 0.0);
    walls.back() = n;
    return walls;
}

std::vector<fragility::StateCounts>
merged(const std::map<double, std::vector<double>>& by_intensity, std::size_t states)
{
    std::vector<fragility::StateCounts> rows;
    for (const auto& [intensity, walls] : by_intensity) {
        rows.push_back({intensity, walls});
        rows.back().walls.resize(states, 0.0);
    }
    return rows;
}

} // namespace

DamageCounts damage_counts(const Csv& csv, const CountColumns& columns)
{
    check_rows(csv);
    const std::size_t intensity = find_column(csv, columns.intensity);
    std::vector<std::size_t> failed;
    for (const std::string& name : columns.failed) failed.push_back(find_column(csv, name));
    const bool by_state = failed.empty();
    const std::size_t state = by_state ? find_column(csv, columns.state) : 0;
    const bool counted = !columns.of.empty();
    const std::size_t of = counted ? find_column(csv, columns.of) : 0;

    std::map<double, std::vector<double>> by_intensity;
    std::size_t states = failed.size() + 1;
    for (const CsvRow& row : csv.rows) {
        const double x = number_at(csv, row, intensity);
        if (!(x > 0.0)) refuse_cell(csv, row, intensity, "is 0; an intensity must be above 0");
        const std::vector<double> walls =
            by_state ? from_state(csv, row, state, counted ? walls_at(csv, row, of) : 1.0)
                     : from_failed(csv, row, of, failed);
        std::vector<double>& sum = by_intensity[x];
        sum.resize(std::max(sum.size(), walls.size()), 0.0);
        for (std::size_t k = 0; k < walls.size(); ++k) sum[k] += walls[k];
        states = std::max(states, walls.size());
    }
    DamageCounts d{std::filesystem::path(csv.path).filename().string(),
                   csv.head[intensity],
                   {},
                   merged(by_intensity, std::max<std::size_t>(states, 2))};
    for (std::size_t k = 1; k < std::max<std::size_t>(states, 2); ++k)
        d.states.push_back(by_state ? csv.head[state] + " >= " + std::to_string(k)
                                    : csv.head[failed[k - 1]]);
    return d;
}

} // namespace app
