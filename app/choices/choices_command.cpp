#include "app/choices/choices_command.hpp"

#include "app/choices/choice_table.hpp"
#include "app/input/study_name.hpp"
#include "app/input/study_reading.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/table_files.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/pushed/push_walls.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "app/text/config_error.hpp"
#include "dem/block/model.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace app {
namespace {

constexpr std::string_view kChoicesList = "drystone_choices_files.txt";

/// Pushes the wall of mean values of one study.
ChoiceResult push_choice(const ChoiceChange& change, int level)
{
    ChoiceResult r{change.key, change.before, change.after, change.not_applied, {}, 1.0};
    if (!change.not_applied.empty()) return r;
    dem::PushPlan plan = push_plan(change.ready.study);
    plan.snapshot_every = 0.0;
    plan.progress = [](const dem::PushProgress&) {
        if (interrupted()) throw Interrupted{"nothing was written"};
    };
    PushList list;
    list.size = 1;
    list.wall = [&](std::size_t) { return WantedWall{level, {}}; };
    list.done = [&](std::size_t, const WallDraw&, PushedWall&& wall) {
        r.height = wall.loads.height;
        if (dem::failed(wall.result.outcome))
            r.reason = "the wall failed: " + wall.reading.no_reading;
        else if (!wall.reading.no_reading.empty())
            r.reason = wall.reading.no_reading;
        else
            r.reading = std::move(wall.reading);
    };
    try {
        push_walls(change.ready.study, model_of(change.ready), plan, list, 1);
    } catch (const ConfigError& error) {
        r.reason = error.what();
    }
    return r;
}

/// All of them, on several threads; the results do not depend on their number.
std::vector<ChoiceResult> push_choices(const std::vector<ChoiceChange>& changes, int level,
                                       int threads, bool quiet)
{
    std::vector<ChoiceResult> results(changes.size());
    Progress progress(std::cerr, stderr_progress(quiet), steady_seconds);
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::size_t done = 0;
    std::exception_ptr error;
    const auto work = [&] {
        for (std::size_t i = next++; i < changes.size(); i = next++) {
            try {
                results[i] = push_choice(changes[i], level);
                const std::lock_guard lock(mutex);
                progress.update(static_cast<double>(++done) /
                                    static_cast<double>(changes.size()),
                                changes[i].key + " = " + changes[i].after);
            } catch (...) {
                const std::lock_guard lock(mutex);
                error = std::current_exception();
                next = changes.size();
            }
        }
    };
    std::vector<std::thread> others;
    for (int i = 1; i < threads; ++i) others.emplace_back(work);
    work();
    for (std::thread& t : others) t.join();
    if (error) std::rethrow_exception(error);
    progress.finish(std::to_string(changes.size() - 1) + " changes");
    return results;
}

} // namespace

int choices_command(const Command& command)
{
    if (is_study_name(command.study))
        throw ConfigError(
            "drystone", 0, "choices",
            "\"" + command.study +
                "\" is a file of results; write the study file that it was made from");
    const PreparedStudy ready = prepare(read_study(command.study, command.overrides));
    const int level = level_of(ready.study.load, command.level);
    std::vector<std::filesystem::path> names = {"choices.svg"};
    for (const char* const ending : kTableEndings)
        names.push_back(std::string("choices") + ending);
    if (const std::string note = check_results(command.out, names, kChoicesList);
        !command.quiet)
        std::cerr << note;
    std::vector<ChoiceChange> changes = {{"as it is", "", "", {}, "", ready}};
    for (ChoiceChange& c : choice_changes(command.study, command.overrides))
        changes.push_back(std::move(c));
    catch_interrupts();
    std::vector<ChoiceResult> results =
        push_choices(changes, level, command.threads, command.quiet);
    const ChoiceResult base = results.front();
    results.erase(results.begin());
    if (!base.reading)
        throw std::runtime_error("the wall of the study gave no result to compare with: " +
                                 base.reason);
    const Table table = choice_results(base, results);
    std::vector<OutputFile> files;
    add_table(files, "choices", table);
    files.push_back({"choices.svg",
                     tornado_svg(tornado(base, results),
                                 "One choice at a time, " +
                                     stress_text(ready.study.load.vertical_stress.at(level)))});
    write_results(command.out, files, kChoicesList);
    std::cout << as_text(without_details(table), terminal_width()) << "written to "
              << command.out << '\n';
    return 0;
}

} // namespace app
