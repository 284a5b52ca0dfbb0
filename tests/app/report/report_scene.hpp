#pragma once
/// A small study run into a file, for tests of its report.

#include "app/input/prepared_study.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/study_runner.hpp"
#include "app/study_scenes.hpp"
#include "dem/block/model.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace scenes {

/// @param failures further walls that failed for this reason, or nothing
inline void run_study(const std::filesystem::path& file, const std::string& uq,
                      const std::string& reason = "", const app::FrameTaker& frames = {})
{
    const app::Study study = study_scenes::study(uq);
    const dem::Model model = app::model_of(app::prepare(study));
    const std::vector<std::uint32_t> sizes = {app::samples_of(study.geometry, study)};
    const app::SamplePlan plan =
        sample_plan(study, study.load, study.source, model.layout, sizes);
    app::StoreHead head = head_of(study, model.layout, plan, sizes);
    head.sessions = {
        {"0.1.0", "a machine", "a build", "2 threads", "2026-01-01T00:00:00Z", "2"}};
    app::Store store(file, head);
    std::vector<app::WallKey> walls = pending_walls(store, {}, false);
    if (!reason.empty()) {
        app::WallRow row;
        row.key = walls.back();
        row.status = 5;
        row.reason = reason;
        row.inputs.assign(head.inputs.size(), 1.0);
        row.responses.assign(head.responses.size(), std::nan(""));
        row.counts.assign(head.counts.size(), -1);
        row.cost.assign(head.cost.size(), 0.0);
        store.append({&row, 1});
        walls.pop_back();
    }
    app::run_walls(app::prepare(study), plan, walls, 2, store, {}, frames);
    store.compact();
}

/// One wall of a study, pushed alone as `drystone push` does.
inline app::PushedWall push_one(const app::Study& study, const app::WallDraw& draw, int level)
{
    app::PushedWall pushed;
    app::PushList list;
    list.size = 1;
    list.wall = [&](std::size_t) -> app::WantedWall { return {level, draw}; };
    list.done = [&](std::size_t, const app::WallDraw&, app::PushedWall&& wall) {
        pushed = std::move(wall);
    };
    app::push_walls(study, app::model_of(app::prepare(study)), app::push_plan(study), list, 1);
    return pushed;
}

} // namespace scenes
