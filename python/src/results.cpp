#include "app/fragility/fragility_data.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/study_file_head.hpp"
#include "app/study/study_walls.hpp"
#include "python/src/arrays.hpp"
#include "python/src/beside_python.hpp"
#include "python/src/bind.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace bindings {
namespace {

namespace py = pybind11;

/// Names, units and meanings of columns, and one array for each.
template <class T>
py::tuple columns_with(const std::vector<app::Column>& columns,
                       std::vector<std::vector<T>>&& numbers)
{
    py::dict arrays, about;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        arrays[py::str(columns[i].name)] = array_of(std::move(numbers[i]));
        about[py::str(columns[i].name)] = py::make_tuple(columns[i].unit, columns[i].meaning);
    }
    return py::make_tuple(arrays, about);
}

template <class T> void append(const std::vector<T>& row, std::vector<std::vector<T>>& columns)
{
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i].push_back(row[i]);
}

/// All of a file but its curves.
py::dict read_walls(const std::string& path)
{
    const Hdf5Turn turn;
    app::check_is_study(path);
    app::StoreReader reader(path);
    const app::StoreHead& head = reader.head();
    std::vector<int> level, sample, status;
    py::list reasons;
    std::vector<std::vector<double>> inputs(head.inputs.size()),
        responses(head.responses.size()), cost(head.cost.size());
    std::vector<std::vector<std::int64_t>> counts(head.counts.size());
    reader.for_each_row([&](const app::WallRow& row) {
        level.push_back(static_cast<int>(row.key.level));
        sample.push_back(static_cast<int>(row.key.sample));
        status.push_back(row.status);
        reasons.append(row.reason);
        append(row.inputs, inputs);
        append(row.responses, responses);
        append(row.counts, counts);
        append(row.cost, cost);
    });
    std::vector<double> stress;
    for (const app::StoreLevel& l : head.levels) stress.push_back(l.vertical_stress);
    const std::size_t missing = app::missing_walls(head, reader.statuses()).size();
    py::dict file;
    file["level"] = array_of(std::move(level));
    file["sample"] = array_of(std::move(sample));
    file["status"] = array_of(std::move(status));
    file["reasons"] = reasons;
    file["vertical_stress"] = array_of(std::move(stress));
    file["missing"] = missing;
    file["configuration"] = head.configuration;
    file["inputs"] = columns_with(head.inputs, std::move(inputs));
    file["responses"] = columns_with(head.responses, std::move(responses));
    file["counts"] = columns_with(head.counts, std::move(counts));
    file["cost"] = columns_with(head.cost, std::move(cost));
    return file;
}

/// Displacement and force of each wall, in the order of read_walls.
py::list read_curves(const std::string& path)
{
    const Hdf5Turn turn;
    app::StoreReader reader(path);
    py::list curves;
    reader.for_each_row([&](const app::WallRow& row) {
        app::WallCurve curve = row.curve;
        curves.append(py::make_tuple(array_of(std::move(curve.displacement)),
                                     array_of(std::move(curve.force))));
    });
    return curves;
}

/// Limit drifts as `drystone fragility` takes them: names of the limit states, and of each level and each state the drifts
/// [%], those that are lower bounds, those that are drift limits, and what these are in words.
py::tuple read_drifts(const std::string& path, const std::vector<std::string>& overrides)
{
    const Hdf5Turn turn;
    const app::DriftData data =
        app::drift_data(app::read_study_walls(path, overrides, app::Keep::readings));
    std::vector<std::string> states;
    for (const app::StateName& s : data.states) states.push_back(app::state_name(s));
    py::list levels;
    for (std::size_t g = 0; g < data.groups.size(); ++g) {
        py::list of_level;
        for (std::size_t s = 0; s < data.states.size(); ++s) {
            std::vector<double> drift;
            py::list censored, capped;
            for (const fragility::Observation& o : app::limits_of(data.groups[g], s)) {
                drift.push_back(o.lower);
                censored.append(o.upper > o.lower);
                capped.append(o.capped);
            }
            of_level.append(py::make_tuple(array_of(std::move(drift)), censored, capped,
                                           app::limit_text(data, g, s)));
        }
        levels.append(of_level);
    }
    return py::make_tuple(states, levels);
}

} // namespace

void bind_results(py::module_& m)
{
    m.def("read_walls", &read_walls, py::arg("path"));
    m.def("read_curves", &read_curves, py::arg("path"));
    m.def("read_drifts", &read_drifts, py::arg("path"), py::arg("overrides"));
}

} // namespace bindings
