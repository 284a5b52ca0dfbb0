#include "app/fragility/intensity/intensity_output.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using Catch::Contains;

namespace {

/// One stress, two intensities, 0.05 and 0.8 g.
app::IntensityData data_of(const std::vector<app::IntensityState>& states)
{
    constexpr double kGravity = 9.80665;
    app::IntensityData data;
    data.histories.name = "scene.h5";
    data.histories.measures = {"pga"};
    data.histories.units = {"m/s2"};
    data.measure.kind = ground::MeasureKind::pga;
    data.unit = "g";
    data.unit_value = kGravity;
    app::HistoryLevel level;
    level.stress = 0.5e6;
    for (const double x : {0.05, 0.8}) {
        app::StoredHistory history;
        history.measures = {x * kGravity};
        level.histories.push_back(history);
    }
    data.histories.levels.push_back(level);
    data.states = states;
    return data;
}

app::IntensityFits curve(double median, double dispersion)
{
    fragility::ClusteredFit fit;
    fit.fit.outcome = fragility::ModelOutcome::converged;
    fit.fit.curve = {median, dispersion};
    app::IntensityFits fits;
    fits.by[0] = fit;
    return fits;
}

/// The numbers of a tag's text.
std::vector<double> numbers(const std::string& xml, const std::string& tag)
{
    const auto at = xml.find(tag);
    REQUIRE(at != std::string::npos);
    const char* text = xml.c_str() + xml.find('>', at) + 1;
    std::vector<double> found;
    for (char* end = nullptr;; text = end) {
        const double x = std::strtod(text, &end);
        if (end == text) return found;
        found.push_back(x);
    }
}

const app::IntensityState kDrift{"drift 0.5 %", app::IntensityResponse::drift, 0.005};
const app::IntensityState kUplift{"uplift of 50 %", app::IntensityResponse::uplift, 0.5};
const app::IntensityState kResidual{"residual 0.2 %", app::IntensityResponse::residual, 0.002};
const app::IntensityState kCollapse{"collapse", app::IntensityResponse::collapse, HUGE_VAL};

} // namespace

TEST_CASE("openquake: curves that cross are lifted, so that no damage state is below 0",
          "[app][openquake]")
{
    const auto data = data_of({kUplift, kDrift});
    const std::string xml =
        app::openquake_xml(data, {{curve(0.250, 0.581), curve(0.230, 0.208)}});
    const auto at = numbers(xml, "<imls");
    const auto milder = numbers(xml, "<poes ls=\"drift_0.5\"");
    const auto severer = numbers(xml, "<poes ls=\"uplift_of_50\"");
    REQUIRE(at.size() == 60);
    REQUIRE(milder.size() == at.size());
    REQUIRE(severer.size() == at.size());
    CHECK(at.front() == Approx(0.005));
    CHECK(at.back() == Approx(1.6));
    for (std::size_t i = 0; i < at.size(); ++i) CHECK(milder[i] >= severer[i]);
    CHECK_THAT(xml, Contains("curves cross, lifted to those of severer states: drift 0.5 %<"));
}

TEST_CASE("openquake: curves in order stay lognormal", "[app][openquake]")
{
    const auto data = data_of({kDrift, kUplift});
    const std::string xml = app::openquake_xml(data, {{curve(0.2, 0.4), curve(0.5, 0.4)}});
    CHECK_THAT(xml, Contains("format=\"continuous\"") && !Contains("lifted") &&
                        !Contains("left out") && Contains("maxIML=\"1.6\""));
}

TEST_CASE("openquake: states and stresses that are not there are named", "[app][openquake]")
{
    auto data = data_of({kDrift, kResidual, kCollapse});
    data.histories.levels.push_back(data.histories.levels.front());
    data.histories.levels.back().stress = 1e6;
    const app::IntensityFits none;
    const std::string xml = app::openquake_xml(
        data, {{curve(0.2, 0.4), curve(0.3, 0.4), none}, {none, none, none}});
    CHECK_THAT(xml, Contains("largest ones: residual 0.2 %") &&
                        Contains("without a curve under 0.50_MPa: collapse") &&
                        Contains("1.00_MPa left out, without a curve of drift 0.5 %"));
}
