#include "app/input/keys/limit_state_text.hpp"
#include "app/input/study/study.hpp"
#include "app/output/cycle_columns.hpp"
#include "app/push/capacity_svg.hpp"
#include "app/push/capacity_text.hpp"
#include "app/push/pushed_picture.hpp"
#include "app/push/summary_json.hpp"
#include "app/reading/points_error.hpp"
#include "app/study/pushed/drawn_wall.hpp"
#include "app/study/pushed/wall_frames.hpp"
#include "fragility/curve/cyclic_curve.hpp"
#include "python/src/arrays.hpp"
#include "python/src/bind.hpp"
#include "python/src/loaded_study.hpp"
#include "python/src/piers.hpp"
#include "python/src/refuse_new.hpp"

#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bindings {
namespace {

namespace py = pybind11;

/// The numbers of a wall, not copied and not to be written.
py::array_t<double> view(const std::vector<double>& numbers, const py::object& owner)
{
    py::array_t<double> array(static_cast<py::ssize_t>(numbers.size()), numbers.data(), owner);
    array.attr("flags").attr("writeable") = false;
    return array;
}

app::Study study_as_used(const WallOfStudy& w)
{
    const app::Study& study = w.study->source.ready.study;
    return study.random.empty() ? study : app::with_drawn(study, {w.level, w.draw});
}

std::string picture(const WallOfStudy& w)
{
    const dem::PushResult& r = w.wall.result;
    if (dem::failed(r.outcome))
        throw std::runtime_error(
            "no picture: the numbers of this run broke; summary[\"outcome\"] says how");
    if (r.at_peak.blocks.empty() && !w.wall.displacement.empty())
        throw std::runtime_error("no picture: push this wall with frames=True");
    const app::Study used = study_as_used(w);
    return app::pushed_picture(used.beam, used.load, w.study->source.ready.layout, w.wall);
}

/// Outlines of the blocks as they stand, [m].
py::list outlines(const dem::Snapshot& shot)
{
    py::list blocks;
    for (const dem::BlockState& block : shot.blocks) {
        std::vector<double> corners;
        for (std::size_t i = 0; i < block.outline.size(); ++i) {
            corners.push_back(block.outline[i].x + block.displacement[i].x);
            corners.push_back(block.outline[i].z + block.displacement[i].z);
        }
        blocks.append(array_of(std::move(corners), block.outline.size(), 2));
    }
    return blocks;
}

/// Displacement, force and outlines of each.
py::list frames(const WallOfStudy& w)
{
    const dem::PushResult& r = w.wall.result;
    py::list all;
    const auto add = [&](const dem::Snapshot& shot) {
        all.append(py::make_tuple(shot.displacement, shot.force, outlines(shot)));
    };
    for (const dem::Snapshot& shot : r.snapshots) add(shot);
    const bool whole =
        !r.snapshots.empty() && r.snapshots.back().displacement == r.at_end.displacement;
    if (!whole && !r.at_end.blocks.empty()) add(r.at_end);
    return all;
}

/// One array for each number of the cycles; nan: a cycle has none.
py::dict cycles(const WallOfStudy& w)
{
    const auto all = fragility::cycles({w.wall.displacement, w.wall.force});
    py::dict columns;
    for (const app::CycleColumn& c : app::cycle_columns(all, w.wall.result.curve)) {
        std::vector<double> numbers;
        for (const std::optional<double>& value : c.values)
            numbers.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
        columns[py::str(std::string(c.name))] = array_of(std::move(numbers));
    }
    return columns;
}

/// @param direction 1 or -1
py::tuple backbone(const WallOfStudy& w, int direction)
{
    fragility::Backbone b = fragility::backbone({w.wall.displacement, w.wall.force}, direction);
    return py::make_tuple(array_of(std::move(b.displacement)), array_of(std::move(b.force)));
}

/// Keys of summary.json of earlier versions, with what they are called now.
py::dict old_summary_keys()
{
    py::dict keys;
    for (const app::WallNumber& n : app::kWallNumbers)
        if (!n.old_key.empty()) keys[py::str(std::string(n.old_key))] = app::summary_key(n);
    return keys;
}

} // namespace

void bind_wall(py::module_& m)
{
    m.def("old_summary_keys", &old_summary_keys);
    py::class_<WallOfStudy> type(m, "Wall");
    make_here_alone(type);
    type.def_property_readonly("level", [](const WallOfStudy& w) { return w.level; })
        .def_property_readonly("sample", [](const WallOfStudy& w) { return w.sample; })
        .def_property_readonly("vertical_stress",
                               [](const WallOfStudy& w) { return w.wall.vertical_stress; })
        .def_property_readonly("height",
                               [](const WallOfStudy& w) { return w.wall.loads.height; })
        .def_property_readonly(
            "failed", [](const WallOfStudy& w) { return dem::failed(w.wall.result.outcome); })
        .def_property_readonly("solver_error",
                               [](const WallOfStudy& w) { return app::solver_error(w.wall); })
        .def_property_readonly(
            "points_error",
            [](const WallOfStudy& w) { return app::points_error(w.wall.result); })
        .def_property_readonly("displacement",
                               [](const py::object& self) {
                                   return view(
                                       self.cast<const WallOfStudy&>().wall.displacement, self);
                               })
        .def_property_readonly("force",
                               [](const py::object& self) {
                                   return view(self.cast<const WallOfStudy&>().wall.force,
                                               self);
                               })
        .def("capacity_csv", [](const WallOfStudy& w) { return app::capacity_text(w.wall); })
        .def("capacity_svg",
             [](const WallOfStudy& w) {
                 return app::capacity_svg(app::reading_rules(study_as_used(w)), w.wall);
             })
        .def("wall_svg", &picture)
        .def("frames", &frames)
        .def("cycles", &cycles)
        .def("piers", &piers_of_wall)
        .def("spandrels", &spandrels_of_wall)
        .def("backbone", &backbone, py::arg("direction"))
        .def("summary_json", [](const WallOfStudy& w) {
            return app::summary_json(study_as_used(w), w.study->source.ready.layout, w.wall);
        });
}

} // namespace bindings
