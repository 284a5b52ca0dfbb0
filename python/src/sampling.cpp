#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/distribution_text.hpp"
#include "app/input/study/units.hpp"
#include "app/sampling/sample_plan.hpp"
#include "dem/scene/layout.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace bindings {
namespace {

namespace py = pybind11;

constexpr const char* kCaller = "uq.sample"; // named in messages

void set_key(app::Study& study, const char* name, const std::string& text)
{
    const app::Key& key = *app::find_key(name);
    try {
        key.field.set(study, app::parse_value(key, text));
    } catch (const app::BadValue& bad) {
        throw app::ConfigError(kCaller, 0, app::name_in_section(name), bad.what());
    }
}

app::RandomInput input(const std::string& name, const std::string& text)
{
    app::RandomInput input;
    input.key = name;
    try {
        input.marginal = app::parse_distribution(text, "");
    } catch (const app::BadValue& bad) {
        throw app::ConfigError(kCaller, 0, name, bad.what());
    }
    return input;
}

/// A study of variables that are not of a wall, under one stress, sampled as any other.
/// @param pearson "a b 0.3, a c -0.2", as uq.pearson
py::array_t<double> sample(const std::vector<std::pair<std::string, std::string>>& variables,
                           int n, const std::string& design, std::uint64_t seed,
                           const std::string& pearson)
{
    app::Study study;
    study.source.path = kCaller;
    for (const auto& [name, text] : variables) study.random.push_back(input(name, text));
    if (study.random.empty())
        throw app::ConfigError(kCaller, 0, "variables",
                               "none; write e.g. {\"x\": \"normal(mean 1, cov 0.25)\"}");
    set_key(study, "uq.design", design);
    set_key(study, "uq.samples", std::to_string(n));
    study.uq.seed = seed;
    study.uq.shared = true;
    study.uq.pearson = pearson;
    study.load.vertical_stress = {0.0};
    const std::array sizes = {static_cast<std::uint32_t>(study.uq.samples)};
    std::vector<double> all;
    {
        const py::gil_scoped_release free;
        const app::SamplePlan plan =
            app::sample_plan(study, study.load, study.source, dem::Layout{}, sizes);
        for (int i = 0; i < study.uq.samples; ++i) {
            const std::vector<double> row = app::flattened(app::draw(plan, 0, i));
            all.insert(all.end(), row.begin(), row.end());
        }
    }
    return array_of(std::move(all), sizes.front(), study.random.size());
}

} // namespace

void bind_sampling(py::module_& m)
{
    m.def("sample", &sample, py::arg("variables"), py::arg("n"), py::arg("design"),
          py::arg("seed"), py::arg("pearson"));
}

} // namespace bindings
