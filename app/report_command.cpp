#include "app/report_command.hpp"

#include "app/atomic_output.hpp"
#include "app/number_text.hpp"
#include "app/progress.hpp"
#include "app/report_data.hpp"
#include "app/report_page.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace app {
namespace {

/// How many walls are shown: as asked for, else as many as kMostFilmedBlocks allows.
std::size_t most_walls(const ReportStudy& study, const std::optional<int>& asked)
{
    if (asked) return static_cast<std::size_t>(*asked);
    const std::size_t blocks = model_of(*study.study).layout.blocks.size();
    return std::max<std::size_t>(10, kMostFilmedBlocks / std::max<std::size_t>(1, blocks));
}

std::string chosen_text(std::size_t shown, std::size_t sound)
{
    if (shown == sound) return "Every wall that gave a result can be looked at.";
    return std::to_string(shown) + " of " + std::to_string(sound) +
           " walls can be looked at: taken in turns from each stress and mode in the order of "
           "the "
           "samples. The option --walls of drystone report takes another number.";
}

struct Shown {
    Replay replay;
    std::string note;
};

Shown show_walls(const ReportStudy& study, const Command& command)
{
    if (!study.study)
        return {{},
                "The walls cannot be pushed again: this version does not read the stored study "
                "file (" +
                    study.no_study + ")."};
    const auto sound = static_cast<std::size_t>(std::count_if(
        study.walls.begin(), study.walls.end(), [](const auto& w) { return !w.failed; }));
    const auto walls = walls_to_show(study, most_walls(study, command.walls));
    if (walls.empty()) return {{}, "No wall was pushed again for this page."};
    Progress progress(std::cerr, stderr_progress(command.quiet), steady_seconds);
    const std::string what = "pushing " + std::to_string(walls.size()) + " walls again";
    Shown shown{replay(study, walls, command.threads,
                       [&](double done) { progress.update(done, what); }),
                chosen_text(walls.size(), sound)};
    progress.finish(what);
    if (shown.replay.different > 0)
        shown.note +=
            " " + std::to_string(shown.replay.different) +
            " of them came out otherwise than stored: the file was written by another "
            "version of the program.";
    return shown;
}

} // namespace

int report_command(const Command& command)
{
    const std::filesystem::path file = command.words.front(), out = command.out;
    const ReportStudy study = read_report_study(file);
    const Shown shown = show_walls(study, command);
    const std::string page = report_page("Drystone study " + study.name,
                                         report_data(study, shown.replay, shown.note));
    if (out.has_parent_path()) make_folder(out.parent_path());
    write_file(out, page);
    std::cout << shown.note << "\nwritten to " << out.string() << ", "
              << fixed(static_cast<double>(page.size()) * 1e-6, 1) << " MB\n";
    return 0;
}

} // namespace app
