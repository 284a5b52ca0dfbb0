#include "app/fragility/numbers/fragility_data.hpp"
#include "app/store/continued_head.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/answers/solver_error.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/check_sum.hpp"
#include "fragility/curve/drift.hpp"
#include "python/src/arrays.hpp"
#include "python/src/beside_python.hpp"
#include "python/src/bind.hpp"
#include "python/src/piers.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <set>
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

/// Is another one once the file holds another study, or other walls of it.
std::string stamp_of(const app::StoreReader& reader)
{
    std::string text = reader.head().configuration;
    for (const app::WallStatus& w : reader.statuses())
        text += std::to_string(w.key.level) + ' ' + std::to_string(w.key.sample) + ' ' +
                std::to_string(w.status) + '\n';
    return app::check_sum(text);
}

/// @param stamp of the file when it was opened
/// @throws app::StoreError if it has changed
void check_stamp(const app::StoreReader& reader, const std::string& path,
                 const std::string& stamp)
{
    if (stamp_of(reader) != stamp)
        throw app::StoreError("'" + path +
                              "' has changed since it was opened: other walls, or another "
                              "study; open it again");
}

/// Walls of a study of both directions that were pushed one way so far: they have no reading.
std::set<app::WallKey> half_pushed(const app::StoreReader& reader)
{
    std::set<app::WallKey> half;
    if (!app::has_turned(reader.head())) return half;
    for (const app::WallStatus& w : reader.statuses())
        if (app::round_of(reader.head(), w.key) == app::Round::own) half.insert(w.key);
    for (const app::WallStatus& w : reader.statuses())
        if (app::round_of(reader.head(), w.key) == app::Round::turned)
            half.erase(app::own_key(reader.head(), w.key));
    return half;
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
    StoredPiers piers(head.piers), spandrels(head.spandrels);
    const std::set<app::WallKey> half = half_pushed(reader);
    reader.for_each_row([&](const app::WallRow& row) {
        if (half.contains(row.key)) return;
        level.push_back(static_cast<int>(row.key.level));
        sample.push_back(static_cast<int>(row.key.sample));
        status.push_back(row.status);
        reasons.append(row.reason);
        append(row.inputs, inputs);
        append(row.responses, responses);
        append(row.counts, counts);
        append(row.cost, cost);
        piers.add(row.piers);
        spandrels.add(row.spandrels);
    });
    std::vector<double> stress;
    for (std::uint32_t l = 0; l < app::own_levels(head); ++l)
        stress.push_back(head.levels[l].vertical_stress);
    const auto missing = std::ranges::count_if(
        app::missing_walls(head, reader.statuses()),
        [&](const app::WallKey& key) { return app::round_of(head, key) == app::Round::own; });
    py::dict file;
    file["level"] = array_of(std::move(level));
    file["sample"] = array_of(std::move(sample));
    file["status"] = array_of(std::move(status));
    file["reasons"] = reasons;
    file["vertical_stress"] = array_of(std::move(stress));
    file["missing"] = static_cast<std::size_t>(missing) + half.size();
    file["stamp"] = stamp_of(reader);
    file["configuration"] = head.configuration;
    file["solver_revision"] = app::solver_revision(head.identity);
    file["inputs"] = columns_with(head.inputs, std::move(inputs));
    file["responses"] = columns_with(head.responses, std::move(responses));
    file["counts"] = columns_with(head.counts, std::move(counts));
    file["piers"] = piers.taken();
    file["spandrels"] = spandrels.taken();
    if (!head.spandrels.places.empty()) file["spandrels"].attr("pop")("storey");
    file["cost"] = columns_with(head.cost, std::move(cost));
    return file;
}

/// Displacement and force of each wall, in the order of read_walls.
py::list read_curves(const std::string& path, const std::string& stamp)
{
    const Hdf5Turn turn;
    app::StoreReader reader(path);
    check_stamp(reader, path, stamp);
    py::list curves;
    const std::set<app::WallKey> half = half_pushed(reader);
    reader.for_each_row([&](const app::WallRow& row) {
        if (half.contains(row.key)) return;
        app::WallCurve curve = row.curve;
        curves.append(py::make_tuple(array_of(std::move(curve.displacement)),
                                     array_of(std::move(curve.force))));
    });
    return curves;
}

/// Limit drifts as `drystone fragility` takes them: names of the limit states, and of each
/// level and each state the drifts [%], those that are lower bounds, those that are drift
/// limits, and what these are in words.
py::tuple read_drifts(const std::string& path, const std::string& stamp,
                      const std::vector<std::string>& overrides)
{
    const Hdf5Turn turn;
    check_stamp(app::StoreReader(path), path, stamp);
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

/// The walls of the audit: level, sample, |value / value of the slower push - 1| of peak force
/// and ultimate displacement. NaN: not defined on one of both. And the study's solver error in
/// words.
py::tuple read_audit(const std::string& path, const std::string& stamp)
{
    const Hdf5Turn turn;
    check_stamp(app::StoreReader(path), path, stamp);
    const app::StudyWalls study = app::read_study_walls(path, {}, app::Keep::readings);
    std::vector<int> level, sample;
    std::vector<double> peak, ultimate;
    for (const app::StudyLevel& l : study.levels)
        for (const app::StudyWall& slow : l.audit) {
            const app::AuditDifference d = app::audit_difference(l, slow);
            level.push_back(static_cast<int>(slow.key.level));
            sample.push_back(static_cast<int>(slow.key.sample));
            peak.push_back(d.peak);
            ultimate.push_back(d.ultimate);
        }
    py::dict columns;
    columns["level"] = array_of(std::move(level));
    columns["sample"] = array_of(std::move(sample));
    columns["peak_force"] = array_of(std::move(peak));
    columns["ultimate_displacement"] = array_of(std::move(ultimate));
    return py::make_tuple(columns, app::solver_error_text(study));
}

/// The walls that were pushed the other way: level, sample and responses.
py::dict read_other_way(const std::string& path, const std::string& stamp)
{
    const Hdf5Turn turn;
    app::StoreReader reader(path);
    check_stamp(reader, path, stamp);
    std::vector<int> level, sample;
    std::vector<std::vector<double>> responses(reader.head().responses.size());
    reader.for_each_turned_row([&](const app::WallRow& row) {
        const app::WallKey own = app::own_key(reader.head(), row.key);
        level.push_back(static_cast<int>(own.level));
        sample.push_back(static_cast<int>(own.sample));
        append(row.responses, responses);
    });
    py::dict columns;
    columns["level"] = array_of(std::move(level));
    columns["sample"] = array_of(std::move(sample));
    for (std::size_t i = 0; i < responses.size(); ++i)
        columns[py::str(reader.head().responses[i].name)] = array_of(std::move(responses[i]));
    return columns;
}

/// Readings of walls one below the other. NaN: not defined on this wall.
struct ReadingColumn {
    std::string name;
    std::vector<double> values;
    std::vector<bool> censored; ///< the value is a lower bound

    void add(double value, bool bound)
    {
        values.push_back(value);
        censored.push_back(bound);
    }
    py::tuple taken() { return py::make_tuple(name, array_of(std::move(values)), censored); }
};

/// How each wall is read, in the order of read_walls: modes, and by name the readings in SI
/// that no column of the file holds, and the drifts of limit states [%].
py::tuple read_readings(const std::string& path, const std::string& stamp,
                        const std::vector<std::string>& overrides)
{
    const Hdf5Turn turn;
    check_stamp(app::StoreReader(path), path, stamp);
    const app::StudyWalls study = app::read_study_walls(path, overrides, app::Keep::readings);
    std::vector<const app::WallNumber*> numbers;
    std::vector<ReadingColumn> columns;
    for (const app::WallNumber& n : app::kWallNumbers)
        if (n.kept == app::Kept::no && n.is_bound != nullptr) {
            numbers.push_back(&n);
            columns.push_back({std::string(n.name), {}, {}});
        }
    for (const app::StateName& s : study.states)
        columns.push_back({app::state_name(s), {}, {}});
    py::list modes, all;
    for (const app::StudyWall* const wall : app::all_walls(study)) {
        const app::WallReading& r = wall->reading;
        const bool read = !wall->failed && r.no_reading.empty();
        modes.append(read ? std::string(name(r.mode)) : std::string());
        auto column = columns.begin();
        for (const app::WallNumber* const n : numbers)
            (column++)->add(n->reading(r, study.height), n->is_bound(r));
        for (const fragility::LimitDisplacement& limit : r.limits)
            (column++)->add(fragility::percent_drift(app::displacement_of(limit), study.height),
                            is_censored(limit));
    }
    for (ReadingColumn& c : columns) all.append(c.taken());
    return py::make_tuple(modes, all);
}

} // namespace

void bind_results(py::module_& m)
{
    m.def("read_walls", &read_walls, py::arg("path"));
    m.def("read_curves", &read_curves, py::arg("path"), py::arg("stamp"));
    m.def("read_drifts", &read_drifts, py::arg("path"), py::arg("stamp"), py::arg("overrides"));
    m.def("read_audit", &read_audit, py::arg("path"), py::arg("stamp"));
    m.def("read_other_way", &read_other_way, py::arg("path"), py::arg("stamp"));
    m.def("read_readings", &read_readings, py::arg("path"), py::arg("stamp"),
          py::arg("overrides"));
}

} // namespace bindings
