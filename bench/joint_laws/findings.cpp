#include "bench/joint_laws/findings.hpp"

#include "app/text/number_text.hpp"
#include "bench/joint_laws/laws.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bench {
namespace {

/// Smallest and largest of the values seen so far.
struct Extent {
    std::size_t n = 0;
    double least = 0.0, most = 0.0;

    void add(double x)
    {
        if (!std::isfinite(x)) return;
        least = n == 0 ? x : std::min(least, x);
        most = n == 0 ? x : std::max(most, x);
        ++n;
    }
};

std::string percent_off(double ratio)
{
    const std::string text = app::fixed(100.0 * (ratio - 1.0), 1);
    return (ratio >= 1.0 ? "+" : "") + text;
}

std::string percents(const Extent& ratios)
{
    return percent_off(ratios.least) + " to " + percent_off(ratios.most) + " %";
}

std::string listed(const std::vector<std::string>& parts)
{
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
    return text;
}

const NamedStudy* named(const NamedStudies& studies, std::string_view file)
{
    for (const NamedStudy& s : studies)
        if (s.name == name_of(file)) return &s;
    return nullptr;
}

std::string forces(const LawRuns& runs)
{
    const NamedStudy* paper = named(runs.random, kPaperLaw);
    if (paper == nullptr || runs.random.size() < 2) return {};
    Extent ratios;
    for (const NamedStudy& s : runs.random)
        for (std::size_t l = 0; &s != paper && l < s.study.walls.levels.size(); ++l)
            if (const auto level = level_at(paper->study, s.study.walls.levels[l].stress))
                ratios.add(mean_peak(s.study, l) / mean_peak(paper->study, *level));
    return "Forces: over all stresses and laws the mean peak of the random walls differs from "
           "that of "
           "the paper's laws by " +
           percents(ratios) + ".";
}

constexpr double kDrift = 1.0; ///< [%]; codes give rocking piers that much

/// "0 % (energy in shear) to 40 % (hyperbolic closure) under 0.50 MPa": least and most walls
/// that are down within kDrift.
std::string shares_at(const NamedStudies& studies, double stress)
{
    std::vector<std::pair<double, std::string>> shares;
    for (const NamedStudy& s : studies)
        if (const auto level = level_at(s.study, stress)) {
            const WallsWithin w = walls_within(s.study, *level, kDrift);
            shares.emplace_back(static_cast<double>(w.down) / static_cast<double>(w.known),
                                s.name);
        }
    const auto [least, most] =
        std::ranges::minmax_element(shares, {}, &std::pair<double, std::string>::first);
    const auto text = [](const auto& s) {
        return app::fixed(100.0 * s.first, 0) + " % (" + s.second + ")";
    };
    const std::string where = " under " + app::fixed(stress * 1e-6, 2) + " MPa";
    if (least->first == most->first)
        return app::fixed(100.0 * least->first, 0) + " % with every law" + where;
    return text(*least) + " to " + text(*most) + where;
}

std::string drift_limits(const LawRuns& runs)
{
    if (runs.random.size() < 2) return {};
    std::vector<std::string> parts;
    for (const double stress : stresses_of(runs.random))
        parts.push_back(shares_at(runs.random, stress));
    return "Drift limits: the share of random walls whose force falls to 80 % of the peak "
           "within a drift of 1 % depends on the law. It is " +
           listed(parts) + ".";
}

/// Ratios of a law's numbers of walls with mean values to the mean of the tests of each stress.
Extent against_tests(const NamedStudy& law, std::span<const TestedWall> tests,
                     WallNumber number)
{
    Extent ratios;
    for (const app::StudyLevel& level : law.study.walls.levels) {
        double sum = 0.0, n = 0.0;
        for (const TestedWall& t : tests)
            if (std::abs(t.stress_MPa * 1e6 - level.stress) < 1.0) {
                sum += number == WallNumber::peak ? t.peak_kN : t.secant_60;
                n += 1.0;
            }
        if (n == 0.0 || level.walls.empty()) continue;
        const app::StudyWall& w = level.walls.front();
        const double ours = number == WallNumber::peak
                                ? app::peak_force(w.reading) * 1e-3
                                : secant(law.study, w, 0.60).value_or(HUGE_VAL);
        ratios.add(ours * n / sum);
    }
    return ratios;
}

std::string beside_tests(const LawRuns& runs, std::span<const TestedWall> tests)
{
    std::vector<std::string> peaks, secants;
    for (const std::string_view file : {kPaperLaw, kAllLaws, kAllExponential}) {
        const NamedStudy* law = named(runs.mean, file);
        if (law == nullptr) continue;
        peaks.push_back(percents(against_tests(*law, tests, WallNumber::peak)) + " (" +
                        law->name + ")");
        secants.push_back(percents(against_tests(*law, tests, WallNumber::secant_60)) + " (" +
                          law->name + ")");
    }
    if (peaks.empty()) return {};
    return "Tests: over their four stresses the peak of the wall with mean values differs from "
           "the mean "
           "of the tests by " +
           listed(peaks) + ", and its stiffness at 60 % of the peak by " + listed(secants) +
           ".";
}

/// Largest ratio, above 1, of one number of two studies of the same law.
void add_ratios(const NamedStudy& a, const NamedStudy& b, Extent& peaks, Extent& drops)
{
    for (std::size_t l = 0; l < a.study.walls.levels.size(); ++l) {
        const auto other = level_at(b.study, a.study.walls.levels[l].stress);
        if (!other || a.study.walls.levels[l].walls.empty() ||
            b.study.walls.levels[*other].walls.empty())
            continue;
        const auto &x = a.study.walls.levels[l].walls.front().reading,
                   &y = b.study.walls.levels[*other].walls.front().reading;
        const auto above_1 = [](double p, double q) { return std::max(p, q) / std::min(p, q); };
        peaks.add(above_1(app::peak_force(x), app::peak_force(y)));
        if (is_observed(x.ultimate) && is_observed(y.ultimate))
            drops.add(above_1(x.ultimate.displacement, y.ultimate.displacement));
    }
}

std::string sureness(const LawRuns& runs)
{
    Extent peaks, drops;
    for (const NamedStudies& law : runs.mean_checks)
        for (std::size_t i = 1; i < law.size(); ++i)
            add_ratios(law.front(), law[i], peaks, drops);
    if (peaks.n == 0 || drops.n == 0) return {};
    return "How sure: another speed of the push or a finer wall changes the peak of a wall "
           "with mean values by up to " +
           app::fixed(100.0 * (peaks.most - 1.0), 1) +
           " % and its 80 % drop by up to a factor of " + app::fixed(drops.most, 2) +
           ". Two laws, or two values of a free choice, must differ by more than this to be "
           "told apart on one wall.";
}

/// Effect of another speed or a finer wall on the numbers of the same random walls.
std::string random_sureness(const LawRuns& runs)
{
    Extent peaks, shares;
    std::size_t walls = 0;
    for (const NamedStudies& law : runs.random_checks)
        for (std::size_t i = 1; i < law.size(); ++i)
            for (std::size_t l = 0; l < law.front().study.walls.levels.size(); ++l) {
                const LawStudy &a = law.front().study, &b = law[i].study;
                const auto other = level_at(b, a.walls.levels[l].stress);
                if (!other) continue;
                const double ratio = mean_peak(b, *other) / mean_peak(a, l);
                peaks.add(std::max(ratio, 1.0 / ratio));
                const auto share = [](const WallsWithin& w) {
                    return static_cast<double>(w.down) / static_cast<double>(w.known);
                };
                shares.add(std::abs(share(walls_within(b, *other, kDrift)) -
                                    share(walls_within(a, l, kDrift))));
                walls = std::max(walls, a.walls.levels[l].walls.size());
            }
    if (peaks.n == 0 || shares.n == 0) return {};
    return "How sure, random walls: another speed or finer blocks change the mean peak of the "
           "same " +
           std::to_string(walls) + " walls under one stress by up to " +
           app::fixed(100.0 * (peaks.most - 1.0), 1) +
           " %, and their share down within a drift of 1 % by up to " +
           app::fixed(100.0 * shares.most, 0) + " points.";
}

/// "8.5 % (1 %), 3.1 % (3 %) and 0.2 % (3 %, fine)" of pairs of value and setting; the value
/// alone where all are equal.
std::string by_setting(const std::vector<std::pair<std::string, std::string>>& values)
{
    const bool one = std::ranges::all_of(
        values, [&](const auto& v) { return v.first == values.front().first; });
    if (one) return values.front().first;
    std::vector<std::string> parts;
    for (const auto& [value, setting] : values) parts.push_back(value + " (" + setting + ")");
    return listed(parts);
}

std::string free_choices(const LawRuns& runs)
{
    std::vector<std::string> parts;
    for (const auto& [name, settings] : {std::pair{"`joint.largest_stiffness`", &runs.limits},
                                         std::pair{"`joint.closure_loss`", &runs.losses}}) {
        std::vector<std::pair<std::string, std::string>> peak_texts, drop_texts;
        for (const NamedStudies& studies : *settings) {
            Extent peaks, drops;
            for (std::size_t i = 1; i < studies.size(); ++i)
                add_ratios(studies.front(), studies[i], peaks, drops);
            if (peaks.n == 0 || drops.n == 0) continue;
            const std::string& first = studies.front().name;
            const std::string setting = first.substr(first.find(", ") + 2);
            peak_texts.emplace_back(app::fixed(100.0 * (peaks.most - 1.0), 1) + " %", setting);
            drop_texts.emplace_back(app::fixed(drops.most, 1), setting);
        }
        if (peak_texts.empty()) continue;
        parts.push_back(std::string(name) +
                        " moves the peak of a wall with mean values by up to " +
                        by_setting(peak_texts) + " and its 80 % drop by up to a factor of " +
                        by_setting(drop_texts));
    }
    return parts.empty() ? "" : "Free choices of closure: " + listed(parts) + ".";
}

} // namespace

std::vector<std::string> findings(const LawRuns& runs, std::span<const TestedWall> tests)
{
    std::vector<std::string> all = {
        forces(runs),   drift_limits(runs),    beside_tests(runs, tests),
        sureness(runs), random_sureness(runs), free_choices(runs)};
    std::erase(all, "");
    return all;
}

} // namespace bench
