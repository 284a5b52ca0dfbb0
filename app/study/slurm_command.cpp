#include "app/study/slurm_command.hpp"

#include "app/input/number_text.hpp"
#include "app/output/atomic_output.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/study/push_walls.hpp"
#include "app/study/shard_script.hpp"
#include "app/study/study_file_head.hpp"
#include "app/study/wall_frames.hpp"
#include "dem/block/model.hpp"
#include "dem/contact/pack.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace app {
namespace {

namespace fs = std::filesystem;

std::size_t wall_count(const Study& study)
{
    return study.load.vertical_stress.size() * samples_of(study);
}

/// [s] of one core for a wall, from the first walls of the study under all its levels.
double seconds_per_wall(const Study& study)
{
    const std::vector<std::uint32_t> sizes = {samples_of(study)};
    const dem::Model model = model_of(study);
    const SamplePlan plan = sample_plan(study, model.layout, sizes);
    const int levels = static_cast<int>(study.load.vertical_stress.size());
    PushList pilot;
    pilot.size = std::min<std::size_t>(dem::lanes<dem::Pack>, wall_count(study));
    pilot.wall = [&](std::size_t i) -> WantedWall {
        const int level = static_cast<int>(i) % levels, sample = static_cast<int>(i) / levels;
        return {level, draw(plan, level, sample)};
    };
    double seconds = 0.0;
    pilot.done = [&](std::size_t, const WallDraw&, PushedWall&& wall) {
        seconds += wall.result.cost.seconds;
    };
    push_walls(study, model, bare_plan(study), pilot, 1);
    return seconds / static_cast<double>(pilot.size);
}

} // namespace

int write_slurm_script(const Study& study, const Command& command)
{
    const double seconds = seconds_per_wall(study);
    const std::size_t walls = wall_count(study);
    ShardScript s;
    s.program = fs::canonical("/proc/self/exe").string();
    s.study = fs::absolute(command.study).string();
    s.out = fs::absolute(command.out).string();
    s.folder = s.out + ".logs";
    s.overrides = command.overrides;
    s.threads = command.threads;
    s.shards = command.shard.count > 1 ? command.shard.count
                                       : shard_count(walls, seconds, command.threads);
    s.minutes = static_cast<double>(walls) * seconds / 60.0 / s.shards / s.threads;
    const fs::path file = command.script;
    if (file.has_parent_path()) make_folder(file.parent_path());
    write_file(file, slurm_script(s));
    std::cout << walls << " walls of " << number(seconds, 2) << " s, " << s.shards
              << " shards of about " << fixed(s.minutes, 1) << " minutes on " << s.threads
              << " threads; submit with: bash " << command.script << '\n';
    return 0;
}

} // namespace app
