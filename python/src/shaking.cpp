#include "app/input/study_reading.hpp"
#include "app/shake/shake_wall.hpp"
#include "python/src/arrays.hpp"
#include "python/src/beside_python.hpp"
#include "python/src/bind.hpp"
#include "python/src/loaded_study.hpp"

#include <pybind11/stl.h>

#include <utility>

namespace bindings {
namespace {

namespace py = pybind11;

py::dict history_of(const app::ShakenWall& wall, const std::string& study)
{
    std::vector<double> time, ground, displacement, base_shear;
    for (const dem::HistoryPoint& p : wall.result.history) {
        time.push_back(p.time);
        ground.push_back(p.ground);
        displacement.push_back(p.displacement);
        base_shear.push_back(p.base_shear);
    }
    py::dict all;
    all["motion"] = wall.motion.name;
    all["height"] = wall.result.top_height;
    all["failed"] = app::shake_failed(wall.result);
    all["summary"] = app::shaken_summary(wall, study);
    all["time"] = array_of(std::move(time));
    all["ground"] = array_of(std::move(ground));
    all["displacement"] = array_of(std::move(displacement));
    all["base_shear"] = array_of(std::move(base_shear));
    return all;
}

/// Shakes the wall that `drystone shake` shakes.
/// @param mean the wall of the mean values
std::vector<py::dict> shake(const std::shared_ptr<LoadedStudy>& study,
                            std::optional<int> sample, bool mean, const std::string& level)
{
    const std::vector<app::ShakingMotion> motions = app::shaking_motions(
        study->source.ready.study.shaking, study->source.ready.study.source);
    const app::PreparedStudy shaken =
        app::shaken_study(study->source.ready, sample.value_or(0));
    const int asked = app::level_of(study->source.ready.study.load, level);
    app::WantedWall wanted;
    for (app::WantedWall& wall : app::wanted_walls(study->source, {sample, mean, level}))
        if (wall.level == asked) wanted = std::move(wall);
    std::vector<app::ShakenWall> walls;
    beside_python([&](Caller& python) {
        app::shake_wall(
            shaken, wanted, motions, 0.0,
            [&](const app::ShakingMotion&, double, double) { python.end_if_asked(); },
            [&](app::ShakenWall&& wall) { walls.push_back(std::move(wall)); });
    });
    const std::string text = app::effective_configuration(shaken.study);
    std::vector<py::dict> all;
    for (const app::ShakenWall& wall : walls) all.push_back(history_of(wall, text));
    return all;
}

} // namespace

void bind_shaking(py::module_& m)
{
    m.def("shake", &shake, py::arg("study"), py::arg("sample"), py::arg("mean"),
          py::arg("level"));
}

} // namespace bindings
