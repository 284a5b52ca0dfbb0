#include "app/input/key_effects.hpp"
#include "app/input/option.hpp"
#include "app/input/study/study_file.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/verb.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/sampling/wall_sites.hpp"
#include "app/scene/scene_units.hpp"
#include "app/study/run_study.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "dem/scene/bond_indices.hpp"
#include "dem/scene/mechanism/quality_terms.hpp"
#include "python/src/arrays.hpp"
#include "python/src/beside_python.hpp"
#include "python/src/bind.hpp"
#include "python/src/loaded_study.hpp"
#include "python/src/refuse_new.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

namespace bindings {
namespace {

namespace py = pybind11;
using StudyPointer = std::shared_ptr<LoadedStudy>;

std::string notes(const LoadedStudy& study)
{
    const app::Verb verb{.name = "study", .sections = app::kWallSections};
    return app::effect_notes(study.source.ready.study, verb);
}

int samples(const LoadedStudy& study) { return static_cast<int>(study.source.sizes.back()); }

std::map<std::string, double> bond(const LoadedStudy& study)
{
    const dem::Layout whole =
        app::whole_units(study.source.ready.study, study.source.ready.study.source);
    const dem::BondIndices i = dem::bond_indices(whole);
    const dem::QualityTerms q = dem::quality_terms(i, whole);
    return {{"trace", i.trace},
            {"trace_ratio", i.trace_ratio},
            {"level_trace_ratio", i.level_trace_ratio},
            {"least_overlap", i.least_overlap},
            {"mean_overlap", i.mean_overlap},
            {"mean_length", i.mean_length},
            {"mean_height", i.mean_height},
            {"long_stones", q.long_stones},
            {"middle_stones", q.middle_stones},
            {"filled", q.filled}};
}

void check_level(const LoadedStudy& study, int level)
{
    if (level < 0 ||
        level >= static_cast<int>(study.source.ready.study.load.vertical_stress.size()))
        throw py::index_error(
            "level " + std::to_string(level) + ": the study has " +
            std::to_string(study.source.ready.study.load.vertical_stress.size()));
}

void check_sample(const LoadedStudy& study, int sample)
{
    if (sample < 0 || sample >= samples(study))
        throw py::index_error("sample " + std::to_string(sample) + ": the study has " +
                              std::to_string(samples(study)) + ", from 0");
}

/// The given columns: name, unit, meaning.
py::list columns(LoadedStudy& study)
{
    py::list list;
    for (const app::Column& c : app::input_columns(plan_of(study)))
        list.append(py::make_tuple(c.name, c.unit, c.meaning));
    return list;
}

/// One array for each number of joints or cracks, by ID.
py::dict places(const std::vector<app::JointPlace>& all)
{
    py::list kind;
    std::vector<int> id, course, unit;
    std::vector<double> x, z, length;
    for (const app::JointPlace& place : all) {
        kind.append(std::string(app::kind_name(place.kind)));
        id.push_back(static_cast<int>(id.size()) + 1);
        course.push_back(place.site.course);
        unit.push_back(place.site.unit);
        x.push_back(place.site.x);
        z.push_back(place.site.z);
        length.push_back(place.length);
    }
    py::dict columns;
    columns["id"] = array_of(std::move(id));
    columns["kind"] = kind;
    columns["course"] = array_of(std::move(course));
    columns["unit"] = array_of(std::move(unit));
    columns["x"] = array_of(std::move(x));
    columns["z"] = array_of(std::move(z));
    columns["length"] = array_of(std::move(length));
    return columns;
}

py::array_t<double> draws(LoadedStudy& study, int level)
{
    check_level(study, level);
    const app::SamplePlan& plan = plan_of(study);
    const auto rows = static_cast<std::size_t>(samples(study));
    std::vector<double> all;
    for (std::size_t sample = 0; sample < rows; ++sample) {
        const std::vector<double> row =
            app::flattened(app::draw(plan, level, static_cast<int>(sample)));
        all.insert(all.end(), row.begin(), row.end());
    }
    const std::size_t width = all.size() / rows;
    return array_of(std::move(all), rows, width);
}

std::vector<WallOfStudy> with_study(const StudyPointer& study,
                                    const std::vector<app::WantedWall>& wanted,
                                    const std::vector<std::optional<int>>& of, int threads,
                                    Snapshots snapshots)
{
    std::vector<app::PushedWall> walls = push_beside_python(*study, wanted, threads, snapshots);
    std::vector<WallOfStudy> all;
    for (std::size_t i = 0; i < walls.size(); ++i)
        all.push_back({study, std::move(walls[i]), wanted[i].level, of[i], wanted[i].draw});
    return all;
}

/// Pushes the wall that `drystone push` pushes, under one stress.
/// @param mean the wall of the mean values
WallOfStudy push(const StudyPointer& study, std::optional<int> sample, bool mean,
                 const std::string& level, int threads, bool frames)
{
    const Snapshots snapshots = frames ? Snapshots::all : Snapshots::at_peak;
    const std::vector<app::WantedWall> all =
        app::wanted_walls(study->source, {sample, mean, level});
    if (!study->source.ready.study.uq.drawn.empty())
        return std::move(with_study(study, all, {sample}, threads, snapshots).front());
    const int asked = app::level_of(study->source.ready.study.load, level);
    for (const app::WantedWall& wall : all)
        if (wall.level == asked)
            return std::move(with_study(study_of(study, sample.value_or(0)), {wall}, {sample},
                                        threads, snapshots)
                                 .front());
    throw std::logic_error("a level without a wall");
}

/// Walls of one layout are pushed side by side, layout by layout.
std::vector<WallOfStudy> push_samples(const StudyPointer& study,
                                      const std::vector<std::pair<int, int>>& asked,
                                      int threads, bool frames)
{
    const app::SamplePlan& plan = plan_of(*study);
    struct Group {
        std::vector<std::size_t> places;
        std::vector<app::WantedWall> wanted;
        std::vector<std::optional<int>> of;
    };
    std::map<StudyPointer, Group> groups;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto [level, sample] = asked[i];
        check_level(*study, level);
        check_sample(*study, sample);
        Group& group = groups[study_of(study, sample)];
        group.places.push_back(i);
        group.wanted.push_back({level, app::draw(plan, level, sample)});
        group.of.emplace_back(sample);
    }
    std::vector<WallOfStudy> all(asked.size());
    for (auto& [own, group] : groups) {
        std::vector<WallOfStudy> walls = with_study(own, group.wanted, group.of, threads,
                                                    frames ? Snapshots::all : Snapshots::none);
        for (std::size_t k = 0; k < walls.size(); ++k)
            all[group.places[k]] = std::move(walls[k]);
    }
    return all;
}

/// @param values one row per wall, in SI
std::vector<WallOfStudy> push_values(const StudyPointer& study, int level,
                                     const GivenNumbers& values, int threads, bool frames)
{
    check_level(*study, level);
    if (values.ndim() != 2)
        throw app::BadValue("inputs: must have two axes, one row per wall and one column per "
                            "input, not " +
                            std::to_string(values.ndim()));
    const app::Study& s = study->source.ready.study;
    const std::vector<int> sites =
        app::sites_of(s.random, s.uq.spatial, study->source.ready.layout);
    std::vector<app::WantedWall> wanted;
    const auto width = static_cast<std::size_t>(values.shape(1));
    const double* from = values.data(); // row by row
    for (py::ssize_t row = 0; row < values.shape(0); ++row, from += width)
        wanted.push_back({level, app::checked_draw(s.random, sites, {from, width})});
    return with_study(study, wanted, std::vector<std::optional<int>>(wanted.size()), threads,
                      frames ? Snapshots::all : Snapshots::none);
}

/// @param progress called with done, failed and all after each wall; None: nothing
void run(const LoadedStudy& study, const std::string& out, int threads, bool rerun_failed,
         const py::object& progress)
{
    app::refuse_drawn(study.source.ready.study.uq, study.source.ready.study.source);
    if (!study.source.ready.study.shaking.records.empty())
        throw app::error_at(study.source.ready.study.source, "shaking.records",
                            "this study shakes walls, and run() pushes them; write "
                            "\"drystone study STUDY.ini\", or take [shaking] out");
    const Hdf5Turn turn;
    bool whole = false;
    beside_python([&](Caller& python) {
        app::StudyRun asked;
        asked.file = out;
        asked.threads = threads > 0 ? threads : app::default_threads();
        asked.rerun_failed = rerun_failed;
        asked.seen = [&](const app::RunProgress& p) {
            if (progress.is_none()) return python.end_if_asked();
            python.visit([&] { progress(p.done, p.failed, p.all); });
        };
        whole = app::run_study(study.source.ready, asked).whole;
        if (whole) (void)app::study_summary(out, true);
    });
    if (!whole)
        throw std::runtime_error(
            "the run was interrupted; the same call resumes where it stopped");
}

} // namespace

void bind_study(py::module_& m)
{
    m.def("load_study", &load_study, py::arg("path"), py::arg("overrides"), py::arg("wall"));
    py::class_<LoadedStudy, StudyPointer> type(m, "LoadedStudy");
    make_here_alone(type);
    type.def("notes", &notes)
        .def("bond", &bond)
        .def_property_readonly("samples", &samples)
        .def_property_readonly(
            "vertical_stress",
            [](const LoadedStudy& s) { return s.source.ready.study.load.vertical_stress; })
        .def_property_readonly("configuration",
                               [](const LoadedStudy& s) {
                                   return app::effective_configuration(s.source.ready.study);
                               })
        .def("level_of",
             [](const LoadedStudy& s, const std::string& text) {
                 return app::level_of(s.source.ready.study.load, text);
             })
        .def("columns", &columns)
        .def("joints",
             [](const LoadedStudy& s) {
                 return places(app::joint_places(s.source.ready.layout));
             })
        .def("cracks",
             [](const LoadedStudy& s) {
                 return places(app::crack_places(s.source.ready.layout));
             })
        .def("draws", &draws, py::arg("level"))
        .def("push", &push, py::arg("sample"), py::arg("mean"), py::arg("level"),
             py::arg("threads"), py::arg("frames"))
        .def("push_samples", &push_samples, py::arg("walls"), py::arg("threads"),
             py::arg("frames"))
        .def("push_values", &push_values, py::arg("level"), py::arg("values"),
             py::arg("threads"), py::arg("frames"))
        .def("run", &run, py::arg("out"), py::arg("threads"), py::arg("rerun_failed"),
             py::arg("progress"));
}

} // namespace bindings
