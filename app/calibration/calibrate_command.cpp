#include "app/calibration/calibration_output.hpp"
#include "app/calibration/test_notes.hpp"
#include "app/calibration/tested_factor.hpp"
#include "app/commands.hpp"
#include "app/fragility/drift_csv.hpp"
#include "app/input/keys/key_values.hpp"
#include "app/input/study_name.hpp"
#include "app/input/study_reading.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/table_files.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/run_study.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLinesFile = "model_factor.ini";
constexpr const char* kPosteriorFile = "posterior.ini";
constexpr const char* kTable = "calibration";

bool is_stored(const Command& command) { return is_study_name(command.study); }

/// The values of --set, with the stresses of --predict behind those of the study.
std::vector<std::string> overrides_of(const Command& command)
{
    std::vector<std::string> all = command.overrides;
    if (command.predict.empty()) return all;
    if (is_stored(command))
        throw ConfigError(
            "drystone", 0, "--predict",
            "the walls of " + command.study +
                " have been pushed already; give the study file, or leave it out");
    constexpr std::string_view kKey = "load.vertical_stress";
    const Study study = read_study(command.study, command.overrides);
    std::vector<double> stresses = study.load.vertical_stress;
    for (const std::string& text : command.predict) {
        const std::vector<double> further = read_at({"drystone", {}, {}, 0}, "--predict", [&] {
            return parse_value(*find_key(kKey), text);
        });
        for (const double stress : further)
            if (std::ranges::none_of(stresses,
                                     [&](double s) { return same_stress(s, stress); }))
                stresses.push_back(stress);
    }
    std::ranges::sort(stresses);
    std::string value;
    for (const double s : stresses)
        value += (value.empty() ? "" : ", ") + number(s / 1e6, kAfterUnits);
    std::erase_if(all,
                  [&](const std::string& o) { return o.starts_with(std::string(kKey) + "="); });
    all.push_back(std::string(kKey) + "=" + value + " MPa");
    return all;
}

/// The walls of a study file are pushed into the folder of the results; those of an earlier run
/// of this verb stay.
fs::path pushed_walls(const Command& command, const PreparedStudy& ready, Progress& progress)
{
    StudyRun run;
    run.file = fs::path(command.out) / "walls.h5";
    run.threads = command.threads;
    run.seen = [&](const RunProgress& p) {
        const auto all = static_cast<double>(std::max<std::size_t>(p.before + p.all, 1));
        progress.update(static_cast<double>(p.before + p.done) / all, "pushing the walls");
    };
    if (!run_study(ready, run).whole)
        throw Interrupted{"the same command resumes where it stopped"};
    return run.file;
}

/// The error of the model as it is, without teaching any input.
int write_factor(const Command& command, const Csv& csv, const std::vector<MeasuredTest>& tests,
                 const StudyWalls& walls)
{
    const TestedFactor drift =
                           tested_factor(tests_over_walls(csv, tests, walls, Answer::drift)),
                       force =
                           tested_factor(tests_over_walls(csv, tests, walls, Answer::force));
    const Table t = factor_table(drift, force);
    const std::string lines = factor_lines(
        drift, force, fs::path(csv.path).filename().string() + " over " + walls.name);
    std::vector<OutputFile> files = {{kLinesFile, lines}};
    add_table(files, kTable, t);
    write_results(command.out, files);
    std::cout << t.title << '\n'
              << as_text(t, terminal_width()) << '\n'
              << lines << "written to " << command.out << '\n';
    return drift.factor || force.factor ? 0 : 1;
}

std::vector<OutputFile> files_of(const CalibrationReport& r, const std::string& source)
{
    std::vector<OutputFile> files = {{"posterior.csv", as_csv(posterior_table(r))},
                                     {"inputs.svg", density_picture(r)}};
    for (std::size_t kind = 0; kind < r.data->quantities.size(); ++kind)
        files.push_back(
            {file_name(r.data->quantities[kind].name) + ".svg", further_wall_picture(r, kind)});
    add_table(files, kTable, test_table(r));
    add_table(files, "inputs", teaching_table(r));
    add_table(files, "further_wall", further_wall_table(r));
    add_table(files, "scatter", scatter_table(r));
    add_table(files, "evidence", evidence_table(r));
    if (uq::has_converged(answer_of((*r.study).calibration, *r.run).posterior))
        files.push_back({kPosteriorFile, posterior_study(r, source)});
    return files;
}

/// The posterior of the inputs that the study names.
int write_posterior(const Command& command, const Csv& csv,
                    const std::vector<MeasuredTest>& tests, const PreparedStudy& ready,
                    const CalibratedInputs& inputs, const StudyWalls& walls, Progress& progress)
{
    CalibrationData data =
        calibration_data(ready.study.source, inputs, walls,
                         tested_quantities(test_readings(csv, ready.study.load.height)), tests);
    const CalibrationRun run = run_calibration(
        ready, inputs, data, command.threads,
        [&](double done, const std::string& what) { progress.update(done, what); });
    progress.finish("learned");
    const CalibrationReport r{&ready.study, &inputs, &tests, &data, &run};
    write_results(command.out, files_of(r, fs::path(csv.path).filename().string()));
    const std::size_t width = terminal_width();
    std::cout << wrapped(answer_text(r), width) << '\n';
    for (const Table& t :
         {teaching_table(r), further_wall_table(r), test_table(r), scatter_table(r)})
        std::cout << t.title << '\n' << as_text(t, width) << '\n';
    const bool converged = uq::has_converged(answer_of(ready.study.calibration, run).posterior);
    std::cout << wrapped(doubt_text(r), width) << "written to " << command.out
              << (converged ? std::string("; ") + kPosteriorFile +
                                  " there is a study with these draws"
                            : "")
              << '\n';
    return converged ? 0 : 1;
}

/// Asks before any wall is pushed what would be replaced, and says it.
void check_place(const Command& command, bool taught)
{
    std::vector<fs::path> names = {taught ? kPosteriorFile : kLinesFile};
    for (const char* const ending : kTableEndings)
        names.push_back(std::string(kTable) + ending);
    const std::string note = check_results(command.out, names);
    if (!command.quiet) std::cerr << note;
}

} // namespace

int calibrate_command(const Command& command)
{
    const Csv csv = read_csv_file(command.words[1]);
    const PreparedStudy ready = study_source(command.study, overrides_of(command)).ready;
    const Study& study = ready.study;
    const std::vector<MeasuredTest> tests = measured_tests(csv, study.load.height);
    check_stresses(csv, tests, study.load.vertical_stress);
    const bool taught = !study.calibration.inputs.empty();
    const CalibratedInputs inputs =
        taught ? calibrated_inputs(study.calibration, study, study.source) : CalibratedInputs{};
    const std::string out_of_reach =
        taught ? protocol_notes(csv, test_readings(csv, study.load.height), tests,
                                push_plan(study).targets)
               : "";
    if (!command.quiet) std::cerr << test_notes(csv, study.load.height, taught) << out_of_reach;
    check_place(command, taught);
    catch_interrupts();
    Progress progress(std::cerr, stderr_progress(command.quiet), steady_seconds);
    const fs::path file =
        is_stored(command) ? fs::path(command.study) : pushed_walls(command, ready, progress);
    const StudyWalls walls = read_study_walls(
        file, is_stored(command) ? command.overrides : std::vector<std::string>{},
        Keep::everything);
    if (taught) return write_posterior(command, csv, tests, ready, inputs, walls, progress);
    progress.finish("pushed all walls");
    return write_factor(command, csv, tests, walls);
}

} // namespace app
