#include "app/input/study/units.hpp"
#include "app/surrogate/learned_surrogate.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/refuse_new.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace bindings {
namespace {

namespace py = pybind11;
using Surrogate = std::shared_ptr<app::LearnedSurrogate>;

/// @throws py::index_error
const app::LearnedLevel& level_at(const Surrogate& s, std::size_t level)
{
    if (level >= s->levels.size())
        throw py::index_error("level: there are " + std::to_string(s->levels.size()) +
                              ", from 0");
    return s->levels[level];
}

std::vector<double> stresses(const Surrogate& s)
{
    std::vector<double> all;
    for (const app::LearnedLevel& level : s->levels) all.push_back(level.stress);
    return all;
}

std::vector<std::string> keys(const Surrogate& s)
{
    std::vector<std::string> all;
    for (const app::LearnedInput& in : s->inputs) all.push_back(in.key);
    return all;
}

std::vector<std::string> doubts(const Surrogate& s, std::size_t level)
{
    return level_at(s, level).doubts;
}

std::pair<std::vector<double>, std::vector<double>> learned_between(const Surrogate& s,
                                                                    std::size_t level)
{
    const app::LearnedLevel& l = level_at(s, level);
    return {{l.least.begin(), l.least.end()}, {l.most.begin(), l.most.end()}};
}

Eigen::MatrixXd rows_of(const GivenNumbers& x)
{
    if (x.ndim() != 2) throw app::BadValue("x: must have two axes, walls and inputs");
    Eigen::MatrixXd rows(x.shape(0), x.shape(1));
    for (py::ssize_t i = 0; i < x.shape(0); ++i)
        for (py::ssize_t k = 0; k < x.shape(1); ++k) rows(i, k) = x.at(i, k);
    return rows;
}

/// Mean and standard deviation in SI, and number of inputs outside.
std::tuple<std::vector<double>, std::vector<double>, std::vector<int>>
predicted(const Surrogate& s, std::size_t level, const GivenNumbers& x)
{
    const app::LearnedLevel& l = level_at(s, level);
    const Eigen::MatrixXd rows = rows_of(x);
    const py::gil_scoped_release free;
    const app::SurrogateAnswers a = app::predict(*s, l, rows);
    return {{a.mean.begin(), a.mean.end()},
            {a.sd.begin(), a.sd.end()},
            {a.outside.begin(), a.outside.end()}};
}

/// Name, probabilities and standard errors of each mode; empty: there is no model of them.
std::vector<std::tuple<std::string, std::vector<double>, std::vector<double>>>
modes(const Surrogate& s, std::size_t level, const GivenNumbers& x)
{
    const app::LearnedLevel& l = level_at(s, level);
    const Eigen::MatrixXd rows = rows_of(x);
    if (!l.modes) return {};
    const py::gil_scoped_release free;
    const app::ModeAnswers a = app::predict_modes(*s, l, rows);
    std::vector<std::tuple<std::string, std::vector<double>, std::vector<double>>> all;
    for (Eigen::Index k = 0; k < a.probability.cols(); ++k) {
        const auto p = a.probability.col(k), sd = a.sd.col(k);
        all.emplace_back(l.modes->names[static_cast<std::size_t>(k)],
                         std::vector<double>(p.begin(), p.end()),
                         std::vector<double>(sd.begin(), sd.end()));
    }
    return all;
}

} // namespace

void bind_surrogate(py::module_& m)
{
    py::class_<app::LearnedSurrogate, Surrogate> learned(m, "LearnedSurrogate");
    make_here_alone(learned);
    learned.def_readonly("response", &app::LearnedSurrogate::response)
        .def_readonly("study", &app::LearnedSurrogate::study)
        .def_property_readonly("keys", &keys)
        .def_property_readonly("stresses", &stresses)
        .def("doubts", &doubts, py::arg("level"))
        .def("learned_between", &learned_between, py::arg("level"))
        .def("predict", &predicted, py::arg("level"), py::arg("x"))
        .def("modes", &modes, py::arg("level"), py::arg("x"));
    m.def(
        "read_surrogate",
        [](const std::string& path) {
            return std::make_shared<app::LearnedSurrogate>(app::read_surrogate(path));
        },
        py::arg("path"));
}

} // namespace bindings
