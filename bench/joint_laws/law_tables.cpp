#include "bench/joint_laws/law_tables.hpp"

#include "app/output/table/cells.hpp"
#include "app/text/number_text.hpp"
#include "bench/limit_drifts.hpp"
#include "bench/validation/cells.hpp"
#include "uq/estimates/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace bench {
namespace {

app::Number mean_cell(const std::vector<double>& values, int decimals)
{
    if (values.size() < 2) return {};
    const uq::Estimate e = uq::estimate_mean(values);
    return app::with_interval(e.value, e.interval, decimals);
}

std::vector<double> peaks_of(const app::StudyLevel& level)
{
    std::vector<double> peaks;
    for (const app::StudyWall& w : level.walls)
        peaks.push_back(app::peak_force(w.reading) * 1e-3);
    return peaks;
}

/// "0.62 (1 of 50 above 1 %)"
std::string errors_text(const LawStudy& study, std::size_t level)
{
    const double borne = study.walls.study.solver.accuracy;
    double worst = 0.0;
    std::size_t above = 0;
    for (const app::StudyWall& w : study.walls.levels[level].walls) {
        worst = std::fmax(worst, w.solver_error);
        above += w.solver_error > borne;
    }
    return app::fixed(100.0 * worst, 1) + (above == 0
                                               ? ""
                                               : " (" + std::to_string(above) + " above " +
                                                     app::number(100.0 * borne, 3) + " %)");
}

/// Geometric mean of ratios with its interval; empty for fewer than two.
app::Number ratio_cell(std::vector<double> ratios)
{
    if (ratios.size() < 2) return {};
    for (double& r : ratios) r = std::log(r);
    const uq::Estimate e = uq::estimate_mean(ratios);
    return app::with_interval(std::exp(e.value), std::exp(e.interval.lower),
                              std::exp(e.interval.upper), 2);
}

app::Row wall_by_wall_row(const app::StudyLevel& first, const app::StudyLevel& other)
{
    std::map<std::uint32_t, const app::StudyWall*> others;
    for (const app::StudyWall& w : other.walls) others[w.key.sample] = &w;
    std::vector<double> peaks, drops;
    std::size_t farther = 0, nearer = 0;
    for (const app::StudyWall& w : first.walls) {
        const auto found = others.find(w.key.sample);
        if (found == others.end()) continue;
        const app::WallReading &a = w.reading, &b = found->second->reading;
        peaks.push_back(app::peak_force(b) / app::peak_force(a));
        if (!is_observed(a.ultimate) || !is_observed(b.ultimate)) continue;
        drops.push_back(b.ultimate.displacement / a.ultimate.displacement);
        farther += drops.back() > 1.2;
        nearer += drops.back() < 1.0 / 1.2;
    }
    return {ratio_cell(peaks), ratio_cell(drops), app::count(nearer), app::count(farther),
            app::count(drops.size())};
}

std::string drop_text(double mm, bool dropped, int decimals)
{
    return (dropped ? "" : "> ") + app::fixed(mm, decimals);
}

std::string number_text(const LawStudy& study, std::size_t level, WallNumber number)
{
    const auto& walls = study.walls.levels[level].walls;
    if (walls.empty()) return "failed";
    const app::StudyWall& w = walls.front();
    switch (number) {
    case WallNumber::peak:
        return app::fixed(app::peak_force(w.reading) * 1e-3, 1);
    case WallNumber::drop:
        return drop_text(w.reading.ultimate.displacement * 1e3, is_observed(w.reading.ultimate),
                         1);
    case WallNumber::secant_30:
    case WallNumber::secant_60:
        break;
    }
    const auto k = secant(study, w, number == WallNumber::secant_30 ? 0.30 : 0.60);
    return k ? app::fixed(*k, 1) : "";
}

std::string number_text(const TestedWall& test, WallNumber number)
{
    switch (number) {
    case WallNumber::peak:
        return app::fixed(test.peak_kN, 1);
    case WallNumber::drop:
        return drop_text(test.drop_mm, test.dropped, 2);
    case WallNumber::secant_30:
        return app::fixed(test.secant_30, 1);
    case WallNumber::secant_60:
        break;
    }
    return app::fixed(test.secant_60, 1);
}

} // namespace

std::vector<double> stresses_of(const NamedStudies& studies)
{
    std::set<double> stresses;
    for (const NamedStudy& s : studies)
        for (const app::StudyLevel& l : s.study.walls.levels)
            stresses.insert(std::round(l.stress));
    return {stresses.begin(), stresses.end()};
}

app::Table random_walls(const NamedStudies& studies)
{
    app::Table t;
    t.keys = 2;
    t.head = limit_head();
    t.head[1] = "laws";
    t.head[2] = {"mean peak [kN]", app::kInterval};
    t.head.insert(t.head.begin() + 4, {"down within 1 % of drift [%]", app::kInterval});
    t.head.insert(t.head.end(),
                  {"walls", "solver error, worst [%]", "steps a wall", "core seconds a wall"});
    for (const double stress : stresses_of(studies))
        for (const NamedStudy& s : studies) {
            const auto level = level_at(s.study, stress);
            if (!level) continue;
            const app::StudyLevel& l = s.study.walls.levels[*level];
            const double n = static_cast<double>(l.walls.size() + l.failed_walls.size());
            app::Row row = limit_row(s.name, s.study.walls, *level);
            row[2] = mean_cell(peaks_of(l), 1);
            const WallsWithin within = walls_within(s.study, *level, 1.0);
            row.insert(row.begin() + 4, share_cell(within.down, within.known));
            row.insert(row.end(), {app::count(n), errors_text(s.study, *level),
                                   app::count(std::round(s.study.costs[*level].steps / n)),
                                   app::plain_number(s.study.costs[*level].seconds / n, 1)});
            t.rows.push_back(std::move(row));
        }
    return t;
}

app::Table wall_by_wall(const NamedStudies& studies)
{
    app::Table t;
    t.keys = 2;
    t.head = {"stress [MPa]",
              "laws",
              {"peak / " + studies.front().name, app::kInterval},
              {"80 % drop / " + studies.front().name, app::kInterval},
              "drop nearer",
              "drop farther",
              "of walls"};
    for (const double stress : stresses_of(studies))
        for (std::size_t i = 1; i < studies.size(); ++i) {
            const auto a = level_at(studies.front().study, stress),
                       b = level_at(studies[i].study, stress);
            if (!a || !b) continue;
            app::Row row = {app::fixed(stress * 1e-6, 2), studies[i].name};
            t.rows.push_back(app::joined(
                std::move(row), wall_by_wall_row(studies.front().study.walls.levels[*a],
                                                 studies[i].study.walls.levels[*b])));
        }
    return t;
}

app::Table mean_walls(const NamedStudies& studies, WallNumber number,
                      std::span<const TestedWall> tests)
{
    const std::vector<double> stresses = stresses_of(studies);
    app::Table t;
    t.head = {"laws"};
    for (const double s : stresses) t.head.emplace_back(app::fixed(s * 1e-6, 2) + " MPa");
    if (!tests.empty()) {
        app::Row row = {std::string("tests")};
        for (const double s : stresses) {
            std::string text;
            for (const TestedWall& w : tests)
                if (std::abs(w.stress_MPa * 1e6 - s) < 1.0)
                    text += (text.empty() ? "" : ", ") + number_text(w, number);
            row.emplace_back(text);
        }
        t.rows.push_back(std::move(row));
    }
    for (const NamedStudy& study : studies) {
        app::Row row = {study.name};
        for (const double s : stresses) {
            const auto level = level_at(study.study, s);
            row.emplace_back(level ? number_text(study.study, *level, number) : "");
        }
        t.rows.push_back(std::move(row));
    }
    return t;
}

app::Table damping_of_cycles(const NamedStudies& studies)
{
    app::Table t;
    t.head = {"laws", "peak [kN]"};
    for (const NamedStudy& s : studies) {
        const auto& walls = s.study.walls.levels.front().walls;
        if (walls.empty()) continue;
        app::Row row = {s.name,
                        app::plain_number(app::peak_force(walls.front().reading) * 1e-3, 1)};
        for (std::size_t c = 0; c < walls.front().cycles.size(); ++c) {
            const fragility::Cycle& cycle = walls.front().cycles[c];
            if (t.head.size() < c + 3)
                t.head.emplace_back(app::fixed(fragility::amplitude(cycle) * 1e3, 0) +
                                    " mm [%]");
            const auto damping = fragility::equivalent_damping(cycle);
            row.emplace_back(damping ? app::plain_number(100.0 * *damping, 1) : app::Number{});
        }
        t.rows.push_back(std::move(row));
    }
    for (app::Row& row : t.rows) row.resize(t.head.size());
    return t;
}

} // namespace bench
