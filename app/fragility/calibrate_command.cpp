#include "app/commands.hpp"
#include "app/fragility/calibration.hpp"
#include "app/fragility/drift_csv.hpp"
#include "app/input/study_reading.hpp"
#include "app/output/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table_files.hpp"
#include "app/study/interrupt.hpp"
#include "app/study/run_study.hpp"
#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLinesFile = "model_factor.ini";
constexpr const char* kTable = "calibration";

/// The walls of a study file are pushed into the folder of the results; those of an earlier run
/// of this verb stay.
fs::path pushed_walls(const Command& command, const Csv& csv,
                      const std::vector<MeasuredTest>& tests)
{
    const PreparedStudy ready = prepare(read_study(command.study, command.overrides));
    check_stresses(csv, tests, ready.study.load.vertical_stress);
    StudyRun run;
    run.file = fs::path(command.out) / "walls.h5";
    run.threads = command.threads;
    Progress progress(std::cerr, stderr_progress(command.quiet), steady_seconds);
    run.seen = [&](const RunProgress& p) {
        const auto all = static_cast<double>(std::max<std::size_t>(p.before + p.all, 1));
        progress.update(static_cast<double>(p.before + p.done) / all, "pushing the walls");
    };
    catch_interrupts();
    if (!run_study(ready, run).whole)
        throw Interrupted{"the same command resumes where it stopped"};
    progress.finish("pushed all walls");
    return run.file;
}

} // namespace

int calibrate_command(const Command& command)
{
    const std::string& table = command.words[1];
    const Csv csv = read_csv_file(table);
    const std::vector<MeasuredTest> tests = measured_tests(csv);
    std::vector<fs::path> names = {kLinesFile};
    for (const char* const ending : kTableEndings)
        names.push_back(std::string(kTable) + ending);
    if (const std::string note = check_results(command.out, names); !command.quiet)
        std::cerr << note;
    const bool stored = command.study.ends_with(".h5");
    const fs::path file = stored ? fs::path(command.study) : pushed_walls(command, csv, tests);
    const StudyWalls walls =
        read_study_walls(file, stored ? command.overrides : std::vector<std::string>{});
    const Calibration drift = calibrated(tests_over_walls(csv, tests, walls, Answer::drift)),
                      force = calibrated(tests_over_walls(csv, tests, walls, Answer::force));
    const Table t = calibration_table(drift, force);
    const std::string lines =
        factor_lines(drift, force, fs::path(table).filename().string() + " over " + walls.name);
    std::vector<OutputFile> files = {{kLinesFile, lines}};
    add_table(files, kTable, t);
    write_results(command.out, files);
    std::cout << t.title << '\n'
              << as_text(t, terminal_width()) << '\n'
              << lines << "written to " << command.out << '\n';
    return drift.factor || force.factor ? 0 : 1;
}

} // namespace app
