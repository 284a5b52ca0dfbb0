#include "app/input/study/units.hpp"
#include "app/text/words.hpp"
#include "core/interval.hpp"
#include "fragility/fits/censored_fit.hpp"
#include "fragility/fits/fit_intervals.hpp"
#include "fragility/fits/kaplan_meier.hpp"
#include "fragility/fits/observed_quantile.hpp"
#include "fragility/limits/limit_quantiles.hpp"
#include "fragility/limits/performance_limits.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/refuse_new.hpp"

#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bindings {
namespace {

namespace py = pybind11;
using fragility::Observation;
using GivenFlags = py::array_t<bool, py::array::c_style | py::array::forcecast>;

/// A law, and the observations that intervals need.
struct LawOfData {
    fragility::Fit fit;
    std::vector<Observation> data;
};

struct NoFit : std::runtime_error {
    using std::runtime_error::runtime_error;
};

fragility::Law law_named(const std::string& name)
{
    if (const auto law = fragility::law(name)) return *law;
    throw app::BadValue("law: " + app::in_quotes(name) +
                        " is none of lognormal, normal, weibull, gamma");
}

/// @param censored empty: all are observed; else true where the wall had not reached the limit
/// state at its value
std::vector<Observation> observations(const GivenNumbers& values, const GivenFlags& censored)
{
    if (values.ndim() != 1) throw app::BadValue("values: must have one axis");
    if (censored.size() != 0 && (censored.ndim() != 1 || censored.size() != values.size()))
        throw app::BadValue("censored: must be as long as values");
    std::vector<Observation> data;
    for (py::ssize_t i = 0; i < values.size(); ++i)
        data.push_back(censored.size() != 0 && censored.at(i)
                           ? fragility::right_censored(values.at(i))
                           : fragility::observed(values.at(i)));
    return data;
}

LawOfData fit(const GivenNumbers& values, const GivenFlags& censored, const std::string& law)
{
    LawOfData fitted{{}, observations(values, censored)};
    const fragility::Law kind = law_named(law);
    {
        const py::gil_scoped_release free;
        fitted.fit = fragility::fit(kind, fitted.data);
    }
    if (fitted.fit.outcome != fragility::FitOutcome::converged) throw NoFit(fitted.fit.reason);
    return fitted;
}

/// "median", "dispersion", "location", or the share of a quantile.
fragility::Quantity quantity_named(const py::object& what)
{
    if (!py::isinstance<py::str>(what)) return fragility::quantile_of(what.cast<double>());
    const auto name = what.cast<std::string>();
    if (name == "median") return fragility::median();
    if (name == "dispersion") return fragility::dispersion();
    if (name == "location") return fragility::location();
    throw app::BadValue(
        app::in_quotes(name) +
        " is none of median, dispersion, location; or give the share of a quantile");
}

py::tuple interval(const LawOfData& f, const py::object& what, double confidence)
{
    const core::Interval i =
        fragility::profile_interval(f.fit, f.data, quantity_named(what), confidence);
    return py::make_tuple(i.lower, i.upper);
}

/// A fit is made again from its data, with the same bits.
py::tuple pickled(const LawOfData& f)
{
    std::vector<double> values;
    std::vector<bool> censored;
    for (const Observation& o : f.data) {
        values.push_back(o.lower);
        censored.push_back(o.upper > o.lower);
    }
    const py::object again = py::module_::import("drystone.fragility").attr("fit");
    return py::make_tuple(again,
                          py::make_tuple(values, censored, std::string(name(f.fit.law.law))));
}

void bind_fit(py::module_& m)
{
    const auto number = [](auto read) {
        return [read](const LawOfData& f) { return read(f.fit); };
    };
    using Fit = fragility::Fit;
    py::class_<LawOfData> type(m, "Fit", "A law fitted to limit drifts, in their unit.");
    make_here_alone(type);
    type.def("__reduce__", &pickled)
        .def_property_readonly(
            "law", [](const LawOfData& f) { return std::string(name(f.fit.law.law)); },
            "lognormal, normal, weibull or gamma.")
        .def_property_readonly(
            "location", number([](const Fit& f) { return f.law.location; }),
            "lognormal: mean of ln drift; normal: mean; weibull: ln scale; gamma: ln mean.")
        .def_property_readonly("dispersion",
                               number([](const Fit& f) { return f.law.dispersion; }),
                               "lognormal: standard deviation of ln drift; normal: of the "
                               "drift; weibull: 1 / shape; gamma: coefficient of variation.")
        .def_property_readonly("location_error",
                               number([](const Fit& f) { return f.location_error; }),
                               "Standard error of the location.")
        .def_property_readonly("dispersion_error",
                               number([](const Fit& f) { return f.dispersion_error; }),
                               "Standard error of the dispersion.")
        .def_property_readonly("log_likelihood",
                               number([](const Fit& f) { return f.log_likelihood; }),
                               "Of the densities of the drifts.")
        .def_property_readonly("aic", number([](const Fit& f) { return f.aic; }),
                               "2 k - 2 ln L, k = 2.")
        .def_property_readonly("bic", number([](const Fit& f) { return f.bic; }),
                               "k ln n - 2 ln L, k = 2.")
        .def_property_readonly("n", number([](const Fit& f) { return f.counts.n; }), "Walls.")
        .def_property_readonly("n_censored",
                               number([](const Fit& f) { return f.counts.right; }),
                               "Walls whose drift is a lower bound.")
        .def_property_readonly(
            "median", number([](const Fit& f) { return fragility::quantile(f.law, 0.5); }),
            "Drift that half of the walls reach.")
        .def("cdf", py::vectorize([](const LawOfData* f, double x) {
                 return fragility::cdf(f->fit.law, x);
             }),
             py::arg("x"), "Share of walls that have reached the limit state at drifts x [-].")
        .def("quantile", py::vectorize([](const LawOfData* f, double p) {
                 return fragility::quantile(f->fit.law, p);
             }),
             py::arg("p"), "Drifts that shares p of the walls reach, p in (0, 1).")
        .def("interval", &interval, py::arg("of"), py::arg("confidence") = 0.95,
             "Interval by profile likelihood of the median, dispersion or location, or of the "
             "drift that a share of the "
             "walls reaches. An infinite end: the data give none.")
        .def("__repr__", [](const LawOfData& f) {
            return py::str("<{} fit of {:g} walls: median {:.4g}, dispersion {:.3g}>")
                .format(std::string(name(f.fit.law.law)), f.fit.counts.n,
                        fragility::quantile(f.fit.law, 0.5), f.fit.law.dispersion);
        });
}

/// One array for each number of the steps.
py::dict kaplan_meier(const GivenNumbers& values, const GivenFlags& censored, double confidence)
{
    const auto km = fragility::kaplan_meier(observations(values, censored), confidence);
    const auto column = [&](auto read) {
        std::vector<double> numbers;
        for (const fragility::KaplanMeierStep& s : km.steps) numbers.push_back(read(s));
        return array_of(std::move(numbers));
    };
    using Step = fragility::KaplanMeierStep;
    py::dict steps;
    steps["at"] = column([](const Step& s) { return s.at; });
    steps["at_risk"] = column([](const Step& s) { return s.at_risk; });
    steps["failed"] = column([](const Step& s) { return s.failed; });
    steps["probability"] = column([](const Step& s) { return s.probability; });
    steps["std_error"] = column([](const Step& s) { return s.std_error; });
    steps["lower"] = column([](const Step& s) { return s.band.lower; });
    steps["upper"] = column([](const Step& s) { return s.band.upper; });
    steps["end"] = km.end;
    constexpr std::array kHalf = {0.5};
    const auto data = observations(values, censored);
    const auto median = fragility::observed_quantiles(data, kHalf, confidence).front();
    steps["median"] = median.value;
    steps["median_interval"] = py::make_tuple(median.interval.lower, median.interval.upper);
    return steps;
}

py::dict performance_limits(const GivenNumbers& values, const GivenFlags& censored,
                            const std::string& law, double confidence)
{
    const std::vector<Observation> data = observations(values, censored);
    const auto limits = fragility::performance_limits(law_named(law), data, confidence);
    if (!limits.fitted) throw NoFit(limits.reason);
    const fragility::ModeGroup walls{data, law_named(law), true};
    const auto chosen = fragility::limit_quantiles({{walls}, true}, limits, confidence);
    const auto column = [&](auto read) {
        std::vector<double> numbers;
        for (const fragility::LimitQuantile& q : chosen.at) numbers.push_back(read(q));
        return array_of(std::move(numbers));
    };
    using Limit = fragility::LimitQuantile;
    py::dict table;
    table["share"] = column([](const Limit& q) { return q.share; });
    table["drift"] = column([](const Limit& q) { return q.value.value_or(core::kInfinity); });
    table["lower"] = column([](const Limit& q) { return q.interval.lower; });
    table["upper"] = column([](const Limit& q) { return q.interval.upper; });
    table["tested_to"] = chosen.tested_to;
    table["dispersion"] = limits.dispersion;
    table["dispersion_interval"] =
        py::make_tuple(limits.dispersion_interval.lower, limits.dispersion_interval.upper);
    table["median_error"] = limits.median_error;
    table["predictive_dispersion"] = limits.predictive_dispersion;
    table["censored_share"] = limits.censored_share;
    table["n"] = limits.n;
    return table;
}

} // namespace

void bind_fragility(py::module_& m)
{
    py::register_exception<NoFit>(m, "NoFit", PyExc_ValueError);
    m.attr("NoFit").attr("__module__") = "drystone";
    m.attr("NoFit").attr("__doc__") = "No law can be fitted to these walls; the text says why.";
    bind_fit(m);
    m.def("fit", &fit, py::arg("values"), py::arg("censored"), py::arg("law"));
    m.def("kaplan_meier", &kaplan_meier, py::arg("values"), py::arg("censored"),
          py::arg("confidence"));
    m.def("performance_limits", &performance_limits, py::arg("values"), py::arg("censored"),
          py::arg("law"), py::arg("confidence"));
}

} // namespace bindings
