/// uq_sampling [OUT.md]: what samples cost, side by side with OpenTURNS where it was found when
/// this was built.

#include "bench/uq/uq_sampling.hpp"

#include "app/text/number_text.hpp"
#include "bench/machine.hpp"
#include "bench/report.hpp"
#include "core/normal.hpp"
#include "uq/designs/design.hpp"
#include "uq/designs/design_criteria.hpp"
#include "uq/designs/latin.hpp"
#include "uq/marginals/marginal.hpp"

#include <iostream>
#include <string>

namespace {

constexpr int kRepeats = 11;

uq::Marginal marginal(int j)
{
    if (j % 2 == 0) return {uq::normal_from_moments(bench::kNormalMean, bench::kNormalCov)};
    return {uq::lognormal_from_moments(bench::kLognormalMean, bench::kLognormalCov)};
}

/// The design in physical units.
Eigen::MatrixXd sample(const uq::Design& design)
{
    Eigen::MatrixXd x = uq::unit_cube(design);
    core::to_normal_quantiles({x.data(), static_cast<std::size_t>(x.size())});
    for (int j = 0; j < design.d; ++j) {
        const uq::Marginal m = marginal(j);
        for (double& value : x.col(j)) value = uq::from_normal(m, value);
    }
    return x;
}

bench::SamplingTimes own_times()
{
    using uq::DesignKind;
    bench::SamplingTimes t;
    t.name = "drystone";
    const auto seed = [](int i) { return static_cast<std::uint64_t>(i); };
    const auto many_of = [&](DesignKind kind) {
        return bench::median_cpu_ms(kRepeats, [&](int i) {
            static_cast<void>(
                sample({kind, {bench::kManySamples}, bench::kManyVariables, seed(i)}));
        });
    };
    t.few_latin =
        bench::median_cpu_ms(101,
                             [&](int i) {
                                 for (int k = 0; k < 20; ++k)
                                     static_cast<void>(sample({DesignKind::latin_random,
                                                               {bench::kFewSamples},
                                                               bench::kFewVariables,
                                                               seed(20 * i + k)}));
                             }) /
        20.0;
    t.many_latin = many_of(DesignKind::latin_random);
    t.many_independent = many_of(DesignKind::monte_carlo);
    t.many_sobol = many_of(DesignKind::sobol);
    t.distance.resize(kRepeats);
    t.spread = bench::median_cpu_ms(kRepeats, [&](int i) {
        t.distance[i] = uq::minimum_distance(uq::unit_cube({DesignKind::latin_optimised,
                                                            {bench::kFewSamples},
                                                            bench::kFewVariables,
                                                            seed(i)}));
    });
    return t;
}

/// Median time of growing a Latin hypercube of 50 x 5 to 100 [ms].
double growing_ms()
{
    const Eigen::MatrixXd start =
        uq::latin_hypercube(50, 5, 1, uq::Place::random, 0, bench::kFewSamples);
    return bench::median_cpu_ms(101,
                                [&](int i) {
                                    for (int k = 0; k < 20; ++k)
                                        static_cast<void>(uq::grow_latin(
                                            start, 100, static_cast<std::uint64_t>(20 * i + k),
                                            uq::Place::random));
                                }) /
           20.0;
}

double median(Eigen::VectorXd x)
{
    std::sort(x.begin(), x.end());
    return x[x.size() / 2];
}

app::Table table(const bench::SamplingTimes& own, const bench::SamplingTimes& other)
{
    const bool compared = !other.name.empty();
    app::Table t;
    t.head = {"task", own.name + " [ms]", compared ? other.name + " [ms]" : "other [ms]",
              "ratio"};
    const auto row = [&](const char* task, double ours, double theirs) {
        t.rows.push_back({task, app::fixed(ours, 3), compared ? app::fixed(theirs, 3) : "",
                          compared ? app::fixed(ours / theirs, 2) : ""});
    };
    row("Latin hypercube 50 x 5", own.few_latin, other.few_latin);
    row("Latin hypercube 10000 x 185", own.many_latin, other.many_latin);
    row("independent 10000 x 185", own.many_independent, other.many_independent);
    row("Sobol' 10000 x 185", own.many_sobol, other.many_sobol);
    row("optimised Latin hypercube 50 x 5", own.spread, other.spread);
    t.rows.push_back(
        {"50 x 5 grown to 100 x 5", app::fixed(growing_ms(), 3), "not offered", ""});
    return t;
}

app::Table distance_table(const bench::SamplingTimes& own, const bench::SamplingTimes& other)
{
    app::Table t;
    t.head = {"optimised 50 x 5 by", "median of the smallest distance [-]", "least", "largest"};
    for (const auto* times : {&own, &other})
        if (!times->name.empty())
            t.rows.push_back({times->name, app::fixed(median(times->distance), 3),
                              app::fixed(times->distance.minCoeff(), 3),
                              app::fixed(times->distance.maxCoeff(), 3)});
    return t;
}

constexpr const char* kOpening =
    R"(CPU time of the whole process, median of 11 runs (101 where under 1 ms), one thread. In physical units: normal (mean 1,
cov 0.25) and lognormal (mean 3.7, cov 0.30) variables in turn; Latin hypercubes drawn anew each time
(`alwaysShuffle` in OpenTURNS).)";

constexpr const char* kDistanceText =
    R"(Annealing of phi_50: here 100 000 exchanges, OpenTURNS T0 = 10, c = 0.95, 20 000 exchanges. Places in the
strata are random in both.)";

} // namespace

int main(int argc, char** argv)
{
    if (argc > 2) {
        std::cerr << "usage: uq_sampling [OUT.md]\n";
        return 2;
    }
    const bench::SamplingTimes own = own_times(), other = bench::openturns_times(kRepeats);
    bench::Report r;
    r.title = "Sampling";
    r.opening = kOpening;
    if (other.name.empty()) r.opening += "\n\nOpenTURNS was not found: no comparison.";
    r.sections.push_back({"", "Times", "", table(own, other)});
    r.sections.push_back(
        {"distance", "Optimised designs", kDistanceText, distance_table(own, other)});
    std::cout << bench::machine_line() << '\n';
    for (const bench::Section& s : r.sections) std::cout << '\n' << app::as_text(s.table);
    if (argc == 2) bench::write_report(argv[1], r);
    return 0;
}
