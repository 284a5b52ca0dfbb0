#include "app/report/report_command.hpp"

#include "app/input/prepared_study.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/replaced_file.hpp"
#include "app/report/report_choice.hpp"
#include "app/report/report_data.hpp"
#include "app/report/report_page.hpp"
#include "app/report/shaken_report.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "dem/scene/layout.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>

namespace app {
namespace {

/// How many walls are shown: as asked for, else as many as kMostFilmedBlocks allows.
std::size_t most_walls(const PreparedStudy& ready, const std::optional<int>& asked)
{
    if (asked) return static_cast<std::size_t>(*asked);
    return walls_in_page(ready.layout.blocks.size());
}

std::string chosen_text(std::size_t shown, std::size_t sound)
{
    if (shown == 0) return "No wall was pushed again for this page.";
    if (shown == sound) return "Click any curve to see its wall.";
    return std::to_string(shown) + " of " + std::to_string(sound) +
           " walls can be shown, taken in turns from each stress and mode in the order of "
           "the samples, to keep the page small. Click on the curve of another wall to see "
           "how to draw it; drystone report --walls N shows more.";
}

/// The page so far, and the listed walls.
struct Draft {
    const StudyWalls& study;
    const PreparedStudy& ready; ///< the same study
    std::string title;
    WallList listed; ///< as walls_to_list
    Json data;

    [[nodiscard]] std::string page(const Replay& replay, const std::string& note) const
    {
        return report_page(title, data, films_json(ready, listed, replay, note));
    }
};

/// Fits of many walls take their time.
Json tested_data(const StudyWalls& study, const WallList& listed, bool quiet)
{
    Progress progress(std::cerr, stderr_progress(quiet), steady_seconds);
    Json data = report_data(study, listed, [&](double done, const std::string& fit) {
        end_if_interrupted();
        progress.update(done, "testing the fit of " + fit);
    });
    progress.finish("tested all fits");
    return data;
}

/// Films of walls, from the shelf or pushed again.
Replay films_of(const PreparedStudy& ready, const WallList& walls, const Command& command,
                const FilmShelf& shelf)
{
    Progress progress(std::cerr, stderr_progress(command.quiet), steady_seconds);
    const auto what = [](std::size_t n) {
        return "pushing " + std::to_string(n) + " walls again";
    };
    Replay all =
        replay(ready, walls, command.threads, shelf, [&](std::size_t done, std::size_t wanted) {
            progress.update(static_cast<double>(done) / static_cast<double>(wanted),
                            what(wanted));
        });
    progress.finish(what(all.pushed));
    return all;
}

/// Leaves the films for which a page of kMostPageBytes has room. Layouts of one study are about
/// as large.
void keep_in_page(const Draft& draft, Replay& replay)
{
    const PreparedStudy& ready = draft.ready;
    const std::size_t geometry = text_of(wall_geometry(ready.layout)).size();
    const std::size_t each = has_layouts(ready.study.geometry) ? geometry : 0;
    const std::size_t rest = draft.page({}, chosen_text(1, 2)).size() + geometry + 100;
    keep_first(replay, kMostPageBytes - std::min(rest, kMostPageBytes), each);
}

struct Shown {
    Replay replay;
    std::string note;
    bool as_expected =
        false; ///< each wall, and each as it is stored: a terminal need not be told
};

Shown show_walls(const Draft& draft, const Command& command, const FilmShelf& shelf)
{
    const StudyWalls& study = draft.study;
    const auto walls = walls_to_show(draft.listed, most_walls(draft.ready, command.walls));
    const std::string other = other_revision_text(study.head);
    const std::string remark = other.empty() ? "" : " " + other;
    if (walls.empty()) return {{}, chosen_text(0, 0) + remark};
    Shown shown{films_of(draft.ready, walls, command, shelf), {}};
    if (!command.walls) keep_in_page(draft, shown.replay);
    std::size_t sound = 0;
    for (const StudyLevel& level : study.levels) sound += level.walls.size();
    shown.note = chosen_text(shown.replay.walls.size(), sound) + remark;
    shown.as_expected =
        shown.replay.walls.size() == sound && remark.empty() && shown.replay.different == 0;
    if (shown.replay.different > 0)
        shown.note += " " + std::to_string(shown.replay.different) +
                      " of them differ from what is stored: the file was written by another "
                      "version of the program.";
    return shown;
}

} // namespace

void check_report(const Command& command)
{
    if (const std::string note = check_replaced(command.out, kPageMark); !command.quiet)
        std::cerr << note;
}

int report_command(const Command& command, const FilmShelf& shelf)
{
    const std::filesystem::path file = command.words.front(), out = command.out;
    check_is_study(file);
    check_report(command);
    catch_interrupts();
    if (holds_histories(read_head(file))) return shaken_report_command(command);
    const StudyWalls study = read_study_walls(file, command.overrides, Keep::everything);
    const std::string title =
        command.title.empty() ? "Drystone study " + file.stem().string() : command.title;
    const PreparedStudy ready = lay_again(study.study);
    Draft draft{study, ready, title, walls_to_list(study, kMostListed), {}};
    draft.data = tested_data(study, draft.listed, command.quiet);
    draft.data["file"] = in_shell(file.string());
    const Shown shown = show_walls(draft, command, shelf);
    const std::string page = draft.page(shown.replay, shown.note);
    if (out.has_parent_path()) make_folder(out.parent_path());
    write_file(out, page);
    if (!shown.as_expected) std::cout << wrapped(shown.note + "\n", terminal_width());
    std::cout << "written to " << out.string() << ", "
              << fixed(static_cast<double>(page.size()) * 1e-6, 1) << " MB\n";
    return 0;
}

} // namespace app
