#include "app/verbs.hpp"

#include "app/choices/choices_command.hpp"
#include "app/commands.hpp"
#include "app/compare/compare_command.hpp"
#include "app/fragility/fragility_command.hpp"
#include "app/fragility/say_answer.hpp"
#include "app/input/sheet_offer.hpp"
#include "app/report/report_command.hpp"
#include "app/shake/shake_study.hpp"
#include "app/sheet/sheet_command.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/study_command.hpp"
#include "app/wall_verbs.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

namespace app {
namespace {

/// Vertical stresses of the walls of a study [Pa].
std::vector<double> stresses_of(const StoreHead& head)
{
    std::vector<double> stresses;
    for (const StoreLevel& level : head.levels)
        if (!level.turned && level.slower <= 1) stresses.push_back(level.vertical_stress);
    return stresses;
}

/// Tables in the folder of the name of the file, the page beside it. Walls are filmed while
/// they are pushed.
int study_then_report(const Command& study, bool shaken)
{
    const std::filesystem::path file = study.out;
    Command tables;
    tables.words = {file.string()};
    tables.study = file.string();
    tables.threads = study.threads;
    tables.verbose = study.verbose;
    tables.report = true; // what the study has said is not said again
    tables.quiet = true;  // what is replaced is said when it is
    tables.out = (file.parent_path() / file.stem()).string();
    Command page = tables;
    page.out += ".html";
    page.title = study.title;
    check_fragility(tables);
    check_report(page);
    FilmShelf films;
    const auto film = [&](auto key, auto mode, auto frames) { films.put(key, mode, frames); };
    // 1 if walls failed: the tables count them
    const int code = shaken ? shake_study_command(study) : study_command(study, film);
    tables.quiet = page.quiet = study.quiet;
    try {
        const int made =
            std::max({code, fragility_command(tables), report_command(page, films)});
        if (!shaken)
            std::cout << sheet_offer(file, "", stresses_of(read_head(file.string()))) << '\n';
        return made;
    } catch (const Interrupted&) {
        throw Interrupted{"all walls are in " + file.string() +
                          ", and the same command makes the tables and the page"};
    }
}

/// A whole study ends with its answer; a shard has none.
int run_study(const Command& command)
{
    const bool shaken =
        is_shaken(with_overrides(read_study_file(command.study), command.overrides));
    if (command.report) return study_then_report(command, shaken);
    if (shaken) return shake_study_command(command);
    const int code = study_command(command);
    if (command.shard.count == 1 && command.script.empty())
        say_answer(command.out, command.quiet);
    return code;
}

int run_report(const Command& command) { return report_command(command); }

constexpr std::size_t kMany = 1'000'000;
constexpr std::size_t kMostCompared = 12; // as many colours as a chart has

constexpr std::array kVerbs = {
    kPushVerb,
    kSceneVerb,
    kNewVerb,
    Verb{.name = "stones",
         .words = "PHOTO.jpg|PHOTO.png",
         .meaning = "find the stones of a photograph: a picture to correct and give to a study",
         .example = "drystone stones wall.jpg",
         .suffix = "_stones",
         .run = stones_command},
    Verb{.name = "study",
         .words = "STUDY.ini",
         .meaning = "push samples x stress levels into one file; an interrupted study resumes",
         .example = "drystone study configs/quick.ini",
         .out = OutKind::file,
         .extension = ".h5",
         .sections =
             "wall lintel stone joint unit beam base shaking load solver output uq fragility",
         .run = run_study},
    Verb{.name = "status",
         .words = "FILE.h5",
         .meaning = "what a file of results holds, how far it is, and since when",
         .example = "drystone status runs/quick.h5",
         .out = OutKind::none,
         .run = status_command},
    Verb{.name = "sample",
         .words = "STUDY.ini",
         .meaning = "write the samples alone, as a table",
         .example = "drystone sample configs/quick.ini",
         .out = OutKind::file,
         .extension = ".csv",
         .suffix = "_samples", // curves of the study have its name
         .sections = "wall lintel stone joint unit beam base load uq",
         .run = sample_command},
    Verb{.name = "reliability",
         .words = "STUDY.ini",
         .meaning = "the probability that a response falls to a demand, and what it depends on",
         .example = "drystone reliability configs/reliability.ini",
         .sections =
             "wall lintel stone joint unit beam base load solver output uq reliability model",
         .run = reliability_command},
    Verb{.name = "fragility",
         .words = "FILE.h5|FILE.csv",
         .meaning =
             "limit drifts, fragility curves and modes of a study, or of a table of drifts",
         .example = "drystone fragility runs/quick.h5",
         .sections = "fragility",
         .run = fragility_command},
    Verb{
        .name = "calibrate",
        .words = "STUDY.ini|FILE.h5 TESTS.csv",
        .meaning =
            "what your own tests teach: the error of the model, or inputs (calibration.inputs)",
        .example = "drystone calibrate configs/quick.ini tests.csv",
        .suffix = "_calibration",
        .least = 2,
        .most = 2,
        .sections = "wall lintel stone joint unit beam base load solver output uq fragility "
                    "calibration",
        .run = calibrate_command},
    Verb{.name = "report",
         .words = "FILE.h5",
         .meaning = "one page for a browser from a study's file",
         .example = "drystone report runs/quick.h5",
         .out = OutKind::file,
         .extension = ".html",
         .run = run_report},
    Verb{.name = "sheet",
         .words = "STUDY.ini|FILE.h5",
         .meaning = "one A4 page of a wall for a client: drawing, curve, limits, how sure",
         .example = "drystone sheet configs/wall.ini",
         .out = OutKind::file,
         .extension = ".html",
         .suffix = "_sheet",
         .sections = kWallSections,
         .run = sheet_command},
    Verb{.name = "choices",
         .words = "STUDY.ini",
         .meaning = "change one choice of the model at a time: what matters for this wall",
         .example = "drystone choices configs/wall.ini",
         .suffix = "_choices",
         .sections = kWallSections,
         .run = choices_command},
    Verb{.name = "compare",
         .words = "A...",
         .meaning = "studies (FILE.h5), folders of pushes and of fragility, measured curves "
                    "(.csv) side by side",
         .example = "drystone compare runs/wall runs/other_wall",
         .suffix = "_compare",
         .least = 1,
         .most = kMostCompared,
         .run = compare_command},
    Verb{.name = "surrogate",
         .words = "FILE.h5",
         .meaning = "learn a response from the walls of a study, and what it depends on",
         .example = "drystone surrogate runs/quick.h5 --of peak_force",
         .suffix = "_surrogate", // tables of the study have its name
         .run = surrogate_command},
    Verb{.name = "curves",
         .words = "FILE.h5",
         .meaning = "all capacity curves of a study as one table",
         .example = "drystone curves runs/quick.h5",
         .out = OutKind::file,
         .extension = ".csv",
         .run = curves_command},
    Verb{.name = "record",
         .words = "FILE|PULSE...",
         .meaning =
             "read records of strong motion: what was read, measures of intensity, pictures",
         .example = "drystone record earthquake.at2",
         .most = kMany,
         .run = record_command},
    Verb{.name = "shake",
         .words = "STUDY.ini",
         .meaning = "shake one wall with records of ground motion: largest and residual drift",
         .example = "drystone shake configs/shaken.ini",
         .suffix = "_shake",
         .sections = "wall lintel stone joint unit beam base shaking load solver output uq",
         .run = shake_command},
    Verb{.name = "serve",
         .words = "STUDY.ini",
         .meaning =
             "let other programs run walls, or ask a surrogate.json, over HTTP (UM-Bridge)",
         .example = "drystone serve configs/quick.ini --port 4242",
         .out = OutKind::none,
         .sections = kWallSections,
         .run = serve_command},
    Verb{.name = "merge",
         .words = "OUT.h5 SHARD.h5...",
         .meaning = "merge the shards of one study into one file",
         .example = "drystone merge runs/paper.h5 runs/paper_*.h5",
         .out = OutKind::first_word,
         .least = 2,
         .most = kMany,
         .run = merge_command},
    kHelpVerb,
    kVersionVerb,
};

} // namespace

std::span<const Verb> verbs() { return kVerbs; }

} // namespace app
