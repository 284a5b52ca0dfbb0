/// How often the drift limits of `drystone fragility` hold the truth, on synthetic studies;
/// writes docs/bench/fragility/limit_coverage.md.

#include "app/input/study/study.hpp"
#include "app/text/number_text.hpp"
#include "bench/report.hpp"
#include "core/interval.hpp"

#include "fragility/fits/goodness_of_fit.hpp"
#include "fragility/fits/observed_quantile.hpp"
#include "fragility/limits/limit_quantiles.hpp"
#include "tests/fragility/fit_data.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace fragility;

constexpr std::size_t kSamples = 199; ///< behind a p-value; the program draws 1000
constexpr double kNowhere = core::kInfinity;

/// Which mode a wall is said to have.
enum class Modes {
    none,     ///< not told: a table without modes
    heap,     ///< its own
    standing, ///< rocking where it stood at the end, as the paper has it
    mistaken  ///< its own, but of one wall in twenty the other
};

struct Heap {
    double share; ///< of the walls [-]
    Distribution law;
};

struct Design {
    std::string name;
    std::vector<Heap> heaps;
    std::size_t walls;
    double first_end, last_end; ///< runs end evenly between these [%]
    Modes modes;
};

Distribution lognormal(double median, double dispersion)
{
    return {Law::lognormal, std::log(median), dispersion};
}

double truth_at(const Design& d, double drift)
{
    double p = 0.0;
    for (const Heap& h : d.heaps) p += h.share * cdf(h.law, drift);
    return p;
}

double truth(const Design& d, double share)
{
    double low = 1e-3, high = 1e3;
    for (int i = 0; i < 200; ++i) {
        const double middle = std::sqrt(low * high);
        (truth_at(d, middle) < share ? low : high) = middle;
    }
    return high;
}

/// One study: what its walls show, and what the same walls would show if all were pushed until
/// they fell.
struct Study {
    std::vector<ModeGroup> seen, whole;
};

Study study(const Design& d, std::uint64_t which)
{
    Study s{std::vector<ModeGroup>(d.modes == Modes::none ? 1 : 2),
            std::vector<ModeGroup>(d.heaps.size())};
    for (std::size_t k = 0; k < d.walls; ++k) {
        const auto u = [&](std::uint64_t i) {
            return uniform(fit_data::bits(40'000'000 + which, 4 * k + i));
        };
        const std::size_t heap = d.heaps.size() > 1 && u(0) >= d.heaps[0].share ? 1 : 0;
        const double x = quantile(d.heaps[heap].law, u(1));
        const double end = d.first_end == d.last_end
                               ? d.first_end
                               : d.first_end + (d.last_end - d.first_end) * u(2);
        std::size_t mode = heap;
        if (d.modes == Modes::none) mode = 0;
        if (d.modes == Modes::standing) mode = x < end ? 0 : 1;
        if (d.modes == Modes::mistaken && u(3) < 0.05) mode = 1 - heap;
        s.seen[mode].limits.push_back(x < end ? observed(x) : right_censored(end));
        s.whole[heap].limits.push_back(heap == 0 && x >= end ? right_censored(end)
                                                             : observed(x));
    }
    std::erase_if(s.seen, [](const ModeGroup& m) { return m.limits.empty(); });
    return s;
}

bool rejected(const std::vector<Observation>& data, std::uint64_t which)
{
    const auto bits = [which](std::uint64_t r, std::uint64_t draw) {
        return fit_data::bits(100'000'000 + 1000 * which + r, draw);
    };
    return least_p(goodness_of_fit(fit(Law::lognormal, data), data, bits, kSamples)) <
           kRejected;
}

struct Tally {
    int held = 0, asked = 0, one_sided = 0;
    double width = 0.0, true_width = 0.0;
    void note(double x, const core::Interval& i)
    {
        ++asked;
        held += i.lower <= x && x <= i.upper;
    }
};

struct Tallies {
    std::array<Tally, kLimitShares.size()> before{}, after{};
};

Tallies tally(const Design& d, int studies)
{
    Tallies t;
    std::array<double, kLimitShares.size()> x{};
    std::ranges::transform(kLimitShares, x.begin(), [&](double p) { return truth(d, p); });
    for (int i = 0; i < studies; ++i) {
        const auto which = static_cast<std::uint64_t>(i);
        Study s = study(d, which);
        std::vector<Observation> all;
        for (const ModeGroup& m : s.seen)
            all.insert(all.end(), m.limits.begin(), m.limits.end());
        const PerformanceLimits law = performance_limits(Law::lognormal, all);
        const bool out = rejected(all, which);
        const auto seen = observed_quantiles(all, kLimitShares);
        for (ModeGroup& m : s.seen)
            m.described = s.seen.size() > 1 ? !rejected(m.limits, which) : !out;
        const LimitQuantiles limits = limit_quantiles({s.seen, !out}, law);
        const auto ideal = mixture_quantiles(s.whole, kLimitShares);
        const Law own = d.heaps.front().law.law;
        const PerformanceLimits true_law =
            own == Law::lognormal ? law : performance_limits(own, all);
        for (std::size_t q = 0; q < x.size(); ++q) {
            if (law.fitted)
                t.before[q].note(x[q], out ? seen[q].interval
                                           : profile_interval(fit(Law::lognormal, all), all,
                                                              quantile_of(kLimitShares[q])));
            if (limits.at.empty()) continue;
            const LimitQuantile& l = limits.at[q];
            t.after[q].note(x[q], l.interval);
            const core::Interval best =
                d.heaps.size() > 1 ? ideal[q].interval : true_law.drifts[q].interval;
            if (std::isfinite(l.interval.upper) && std::isfinite(best.upper) && l.value) {
                t.after[q].width += l.interval.upper - l.interval.lower;
                t.after[q].true_width += best.upper - best.lower;
            } else {
                ++t.after[q].one_sided;
            }
        }
    }
    return t;
}

/// Walls whose law is not the one that the table fits.
std::vector<std::pair<std::string, Distribution>> other_laws()
{
    return {{"Weibull's law, shape 2.2", {Law::weibull, std::log(1.8), 1.0 / 2.2}},
            {"Weibull's law, shape 4", {Law::weibull, std::log(1.8), 1.0 / 4.0}},
            {"a gamma law, scatter 0.5", {Law::gamma, std::log(1.8), 0.5}}};
}

std::vector<Design> designs()
{
    const std::vector<Heap> one = {{1.0, lognormal(1.6, 0.45)}};
    const std::vector<Heap> close = {{0.5, lognormal(1.0, 0.3)}, {0.5, lognormal(2.0, 0.3)}};
    const std::vector<Heap> rocking = {{0.7, lognormal(1.5, 0.45)},
                                       {0.3, lognormal(9.0, 0.12)}};
    const std::vector<Heap> few = {{0.85, lognormal(1.4, 0.6)}, {0.15, lognormal(8.8, 0.12)}};
    const std::vector<Heap> many = {{0.7, lognormal(1.4, 0.5)}, {0.3, lognormal(8.8, 0.12)}};
    std::vector<Design> all = {
        {"one law, stopped at the median", one, 25, 1.6, 1.6, Modes::none},
        {"the same", one, 50, 1.6, 1.6, Modes::none},
        {"one law, pushed to the drop", one, 25, kNowhere, kNowhere, Modes::none},
        {"the same", one, 50, kNowhere, kNowhere, Modes::none}};
    for (const Modes m : {Modes::heap, Modes::none}) {
        all.push_back({"two close heaps, stopped at 2.73 %", close, 50, 2.73, 2.73, m});
        all.push_back({"30 % rock at 9 %, stopped at 2.73 %", rocking, 25, 2.73, 2.73, m});
        all.push_back({"the same", rocking, 50, 2.73, 2.73, m});
        all.push_back(
            {"15 % rock at 8.8 %, pushed to the drop", few, 50, kNowhere, kNowhere, m});
        all.push_back(
            {"30 % rock at 8.8 %, pushed to the drop", many, 50, kNowhere, kNowhere, m});
    }
    all.push_back({"30 % rock at 9 %, stopped at 2.73 %, rocking = stood", rocking, 50, 2.73,
                   2.73, Modes::standing});
    all.push_back({"30 % rock, runs end at 1 to 2.75 %", rocking, 50, 1.0, 2.75, Modes::heap});
    all.push_back({"30 % rock at 8.8 %, to the drop, one mode in twenty mistaken", many, 50,
                   kNowhere, kNowhere, Modes::mistaken});
    all.push_back({"250 walls, 30 % rock at 9 %, stopped at 2.73 %", rocking, 250, 2.73, 2.73,
                   Modes::heap});
    for (const auto& [name, law] : other_laws())
        for (const std::size_t walls : {25U, 50U})
            for (const double end : {quantile(law, 0.5), kNowhere})
                all.push_back({name + (end < kNowhere ? ", stopped at the median"
                                                      : ", pushed to the drop"),
                               {{1.0, law}},
                               walls,
                               end,
                               end,
                               Modes::none});
    return all;
}

const char* told(Modes m)
{
    switch (m) {
    case Modes::none:
        return "not told";
    case Modes::heap:
        return "told";
    case Modes::standing:
        return "stood or fell";
    case Modes::mistaken:
        return "1 of 20 mistaken";
    }
    return "";
}

app::Number tenth(double x) { return {.value = x, .decimals = 1}; }

/// Percentages of the studies that hold the truth, or of one-sided answers, or widths over
/// those of the true model.
template <class Read>
app::Row row_of(const Design& d, const std::array<Tally, kLimitShares.size()>& tallies,
                const char* what, const Read& read)
{
    app::Row row = {d.name, std::to_string(d.walls), told(d.modes), what};
    for (const Tally& t : tallies) row.emplace_back(read(t));
    return row;
}

void add_rows(app::Table& table, const Design& d, const Tallies& t)
{
    const auto held = [](const Tally& x) { return tenth(100.0 * x.held / x.asked); };
    const auto open = [](const Tally& x) { return tenth(100.0 * x.one_sided / x.asked); };
    const auto width = [](const Tally& x) {
        return x.true_width > 0.0 ? app::Number{.value = x.width / x.true_width, .decimals = 2}
                                  : app::Number{};
    };
    table.rows.push_back(row_of(d, t.before, "held before [%]", held));
    table.rows.push_back(row_of(d, t.after, "held [%]", held));
    table.rows.push_back(row_of(d, t.after, "one-sided [%]", open));
    table.rows.push_back(row_of(d, t.after, "width", width));
}

void write(const std::string& path, int studies)
{
    app::Table table;
    table.head = {"walls as", "n", "modes", "what", "5 %", "16 %", "50 %", "84 %", "95 %"};
    for (const Design& d : designs()) add_rows(table, d, tally(d, studies));
    const std::string opening =
        "How often do the 95 % intervals of the drift limits of "
        "`drystone fragility` hold the truth? " +
        std::to_string(studies) +
        " synthetic studies of each kind, by the functions of the "
        "program (fragility/limits/limit_quantiles.hpp) in this process; " +
        std::to_string(kSamples) +
        " samples behind each p-value in place of 1000. Before: one "
        "law of all walls, or the observed shares where the "
        "Kolmogorov-Smirnov, Cramer-von Mises, Anderson-Darling or "
        "two-heaps test rejects it. A one-sided answer (\"> 2.72\", "
        "or an interval without an upper end) holds the truth where "
        "the truth lies above its lower end. Width: mean over that of "
        "the true model, where both are two-sided; the true model "
        "knows the law and the heap of each wall, and sees the upper heap fall. "
        "Standard error of 95 %: " +
        app::fixed(100.0 * std::sqrt(0.95 * 0.05 / studies), 1) + " %.";
    bench::write_report(path, {"Coverage of drift limits", opening, {{"", "", "", table}}});
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc < 2 || argc > 3) {
        std::fputs("usage: limit_coverage OUT.md [STUDIES=400]\n", stderr);
        return 2;
    }
    write(argv[1], argc > 2 ? std::atoi(argv[2]) : 400);
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "limit_coverage: %s\n", e.what());
    return 1;
}
