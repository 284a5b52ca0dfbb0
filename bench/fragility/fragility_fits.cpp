/// CPU time of censored fits and goodness of fit; writes
/// docs/bench/fragility/fragility_fits.md.

#include "bench/report.hpp"

#include "fragility/fits/fit_intervals.hpp"
#include "fragility/fits/goodness_of_fit.hpp"
#include "fragility/limits/stress_model.hpp"
#include "tests/fragility/fit_data.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

namespace {

using namespace fragility;

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Least CPU time of several runs [s]; each run repeats until the clock can resolve it.
template <class F> double least_cpu(int runs, int repeats, F work)
{
    double best = 1e300;
    for (int r = 0; r < runs; ++r) {
        const double start = cpu_seconds();
        for (int i = 0; i < repeats; ++i) work();
        best = std::min(best, (cpu_seconds() - start) / repeats);
    }
    return best;
}

std::string shown(double x, const char* format)
{
    char text[32];
    std::snprintf(text, sizeof text, format, x);
    return text;
}

struct Row {
    std::string task;
    double seconds;
    std::string target;
};

std::vector<Row> fits(const std::vector<Observation>& data)
{
    std::vector<Row> rows;
    double sink = 0.0;
    for (const Law law : {Law::lognormal, Law::normal, Law::weibull, Law::gamma})
        rows.push_back({"fit, " + std::string(name(law)) + ", with standard errors",
                        least_cpu(7, 200, [&] { sink += fit(law, data).log_likelihood; }),
                        law == Law::lognormal ? "0.0003" : ""});
    const Fit f = fit(Law::lognormal, data);
    rows.push_back(
        {"profile interval of the median",
         least_cpu(5, 10, [&] { sink += profile_interval(f, data, median()).lower; }), ""});
    rows.push_back(
        {"goodness of fit, p by 1000 refits",
         least_cpu(
             3, 1,
             [&] { sink += goodness_of_fit(f, data, fit_data::bits).p_anderson_darling; }),
         ""});
    std::vector<StressedObservation> stressed;
    for (std::size_t i = 0; i < data.size(); ++i)
        stressed.push_back({0.25 * static_cast<double>(1 + i % 5), data[i]});
    rows.push_back({"stress model, degrees by AIC (9 fits)",
                    least_cpu(5, 5, [&] { sink += fit_stress_model(stressed).aic; }), ""});
    if (sink == 0.0) std::puts("");
    return rows;
}

void write(const std::string& path)
{
    const auto data = fit_data::stopped_at(fit_data::lognormal350, 0.018);
    bench::Section section;
    section.text =
        "350 drifts, 71 of them right-censored (tests/fragility/fit_data.hpp, checked "
        "there against R). One core, CPU time, least of 3 to 7 runs.";
    section.table.head = {"task", "CPU time [ms]", "aim [ms]"};
    for (const Row& r : fits(data)) {
        const std::string aim =
            r.target.empty() ? "" : shown(1e3 * std::stod(r.target), "%.1f");
        section.table.rows.push_back({r.task, shown(1e3 * r.seconds, "%.4g"), aim});
    }
    bench::write_report(path,
                        {"Speed of fits",
                         "The observations are put on the axis of the law once; the search "
                         "is Newton's in location / dispersion and 1 / dispersion, where "
                         "the likelihood is concave (fragility/fits/censored_likelihood.hpp).",
                         {section}});
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc != 2) {
        std::fputs("usage: fragility_fits OUT.md\n", stderr);
        return 2;
    }
    write(argv[1]);
    return 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "fragility_fits: %s\n", e.what());
    return 1;
}
