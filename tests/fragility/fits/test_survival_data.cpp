/// Writes random data and their fits for check_survival.sh, which compares them with R.

#include "fragility/fits/bootstrap_random.hpp"
#include "fragility/fits/censored_fit.hpp"
#include "fragility/modes/mode_model.hpp"
#include "tests/fragility/fit_data.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>

using namespace fragility;

namespace {

/// Sixty walls: observed, right-, left- and interval-censored in turns that depend on the set.
std::vector<Observation> random_walls(std::uint64_t set)
{
    const Distribution law{Law::lognormal, 0.7, 0.2 + 0.1 * static_cast<double>(set % 5)};
    std::vector<Observation> data;
    for (std::uint64_t k = 0; k < 60; ++k) {
        const double x = quantile(law, uniform(fit_data::bits(set, 3 * k)));
        const double limit =
            quantile(law, 0.2 + 0.75 * uniform(fit_data::bits(set, 3 * k + 1)));
        const double kind = uniform(fit_data::bits(set, 3 * k + 2));
        if (kind < 0.1 && set % 2 == 1)
            data.push_back(x < limit ? left_censored(limit) : right_censored(limit));
        else if (kind < 0.2 && set % 3 == 1)
            data.push_back(Observation{0.8 * x, 1.3 * x});
        else
            data.push_back(x < limit ? observed(x) : right_censored(limit));
    }
    return data;
}

std::string text(double x)
{
    if (std::isinf(x)) return x > 0.0 ? "Inf" : "-Inf";
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.17g", x);
    return buffer;
}

void write_fits(const std::string& folder)
{
    std::ofstream data(folder + "/data.csv");
    std::ofstream fits(folder + "/fits.csv");
    data << "set,lower,upper\n";
    fits << "set,law,location,dispersion,se_location,se_log_dispersion,log_likelihood\n";
    for (std::uint64_t set = 0; set < 12; ++set) {
        const auto walls = random_walls(set);
        for (const Observation& o : walls)
            data << set << ',' << text(o.lower) << ',' << text(o.upper) << '\n';
        for (const Law law : {Law::lognormal, Law::normal, Law::weibull, Law::gamma}) {
            const Fit f = fit(law, walls);
            REQUIRE(f.outcome == FitOutcome::converged);
            fits << set << ',' << name(law) << ',' << text(f.law.location) << ','
                 << text(f.law.dispersion) << ',' << text(f.location_error) << ','
                 << text(std::sqrt(f.covariance(1, 1))) << ',' << text(f.log_likelihood)
                 << '\n';
        }
    }
}

void write_modes(const std::string& folder)
{
    std::ofstream data(folder + "/modes.csv");
    std::ofstream fits(folder + "/mode_fits.csv");
    data << "set,x,n0,n1,n2\n";
    fits << "set,a1,b1,a2,b2,se_a1,se_b1,se_a2,se_b2\n";
    for (std::uint64_t set = 0; set < 5; ++set) {
        ModeData d{Eigen::MatrixXd(5, 1), Eigen::MatrixXd(5, 3)};
        for (int i = 0; i < 5; ++i) {
            d.covariates(i, 0) = 0.25 * (i + 1);
            for (int k = 0; k < 3; ++k)
                d.counts(i, k) =
                    1.0 + static_cast<double>(fit_data::below(
                              fit_data::bits(set, static_cast<std::uint64_t>(3 * i + k)), 20));
            data << set << ',' << text(d.covariates(i, 0)) << ',' << d.counts(i, 0) << ','
                 << d.counts(i, 1) << ',' << d.counts(i, 2) << '\n';
        }
        const ModeModel m = fit_modes(d);
        REQUIRE(m.outcome == ModelOutcome::converged);
        fits << set;
        for (const auto& table : {m.coefficients, m.std_errors})
            for (int k = 0; k < 2; ++k)
                for (int j = 0; j < 2; ++j) fits << ',' << text(table(k, j));
        fits << '\n';
    }
}

} // namespace

TEST_CASE("survival data: random data and their fits, for R", "[.][survival_data]")
{
    const char* folder = std::getenv("FITS_FOLDER");
    REQUIRE(folder != nullptr);
    write_fits(folder);
    write_modes(folder);
}
