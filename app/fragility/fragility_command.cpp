#include "app/fragility/fragility_command.hpp"

#include "app/fragility/damage_curves.hpp"
#include "app/fragility/drift_csv.hpp"
#include "app/fragility/intensity/intensity_output.hpp"
#include "app/fragility/study_output.hpp"
#include "app/input/keys/key_reading.hpp"
#include "app/input/study_checks.hpp"
#include "app/input/study_name.hpp"
#include "app/input/study_reading.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/table_files.hpp"
#include "app/store/store_reader.hpp"
#include "app/store/wall_file.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/text/config_error.hpp"
#include "app/text/text_file.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <array>
#include <iostream>

namespace app {
namespace {

namespace fs = std::filesystem;

/// fragility.key=value without a study; keys that need curves are refused.
DriftOptions options_of(const std::vector<std::string>& overrides)
{
    constexpr std::array<std::string_view, 3> kNames = {"fragility.law", "fragility.confidence",
                                                        "fragility.bootstrap"};
    Study study;
    study.source = with_overrides({}, overrides);
    for (const Entry& e : study.source.entries)
        if (std::ranges::count(kNames, e.key) == 0)
            throw ConfigError("--set", 0, e.key,
                              "for a table, only fragility.law=..., fragility.confidence=... "
                              "and fragility.bootstrap=... can be set");
    for (const std::string_view name : kNames)
        if (find_entry(study.source, name)) read_key(*find_key(name), study);
    check_bootstrap(study.fragility, study.source);
    return drift_options(study.uq, study.fragility);
}

/// A missing or damaged FILE.h5 is a study too: its reader says what is wrong with it.
bool is_study(const std::string& path) { return is_study_name(path) || begins_as_hdf5(path); }

/// "; its columns are \"wall\", \"drift [%]\""
std::string columns_text(const Csv& csv)
{
    constexpr std::size_t kShown = 12;
    std::string text = "; its columns are ";
    for (std::size_t c = 0; c < std::min(kShown, csv.head.size()); ++c)
        text += (c > 0 ? ", " : "") + in_quotes(csv.head[c]);
    if (csv.head.size() > kShown)
        text += " and " + std::to_string(csv.head.size() - kShown) + " more";
    return text;
}

void check_columns(const Command& command, const Csv* table)
{
    const bool drifts =
        !command.drift.empty() || !command.censored.empty() || !command.group.empty();
    const bool counts = !command.failed.empty() || !command.state.empty() ||
                        !command.of.empty() || !command.intensity.empty();
    const auto refuse = [](const char* option, const std::string& why) {
        throw ConfigError("drystone", 0, option, why);
    };
    if (table == nullptr && (drifts || counts))
        refuse("--drift, --intensity, ...", "a study has no columns; leave these options out");
    if (table == nullptr) return;
    if (drifts && counts)
        refuse(
            "--intensity, --failed, --of, --state",
            "belong to a table of counts, not to one of drifts; leave out --drift, --censored "
            "and --group");
    if (!drifts && !counts)
        refuse("--drift", "missing; name the column of drifts in " + in_quotes(command.study) +
                              ", or --intensity, --failed and --of of a table of counts" +
                              columns_text(*table));
    if (drifts && command.drift.empty())
        refuse("--drift", "missing; name the column of drifts in " + in_quotes(command.study) +
                              columns_text(*table));
    if (!counts) return;
    if (command.intensity.empty())
        refuse("--intensity", "missing; name the column of intensities");
    if (command.failed.empty() == command.state.empty())
        refuse("--failed",
               "name either the columns of the numbers that reached the limit states, "
               "or with --state the column of damage states");
    if (command.state.empty() && command.of.empty())
        refuse("--of", "missing; name the column of the total numbers of walls");
}

void refuse_study_file(const std::string& path)
{
    if (!path.ends_with(".ini")) return;
    const std::string results = "runs/" + fs::path(path).stem().string() + ".h5";
    throw ConfigError(path, 0, "",
                      "is a study file and has no results yet; write \"drystone study " + path +
                          "\", then \"drystone fragility " + results + "\"");
}

/// The tables that are the answer, as a terminal gets them.
std::string answers_text(const FragilityOutput& output, const Command& command,
                         std::size_t width)
{
    std::string text;
    for (const NamedTable& t : output.tables) {
        if (!t.answer) continue;
        if (t.in_summary && command.report && !command.verbose) continue;
        const Table shown = command.verbose ? t.table : short_table(t);
        text += t.table.title + "\n";
        if (!shown.rows.empty()) text += as_text(shown, width);
        const std::size_t rows = t.table.rows.size();
        const bool all_rows = shown.rows.size() == rows;
        const std::string what = all_rows ? "all columns"
                                 : shown.rows.empty()
                                     ? std::to_string(rows) + " rows"
                                     : std::to_string(shown.rows.size()) + " of " +
                                           std::to_string(rows) + " rows; all rows and columns";
        if (!all_rows || shown.head.size() < t.table.head.size())
            text += wrapped(what + ": --verbose, or " +
                                (fs::path(command.out) / t.name).string() + ".md\n",
                            width);
        text += "\n";
    }
    return text;
}

void check_lognormal(const std::vector<std::string>& overrides)
{
    for (const Entry& e : with_overrides({}, overrides).entries)
        if (e.key != "fragility.confidence")
            throw ConfigError("--set", 0, e.key,
                              "has no effect on counts, which have lognormal curves and "
                              "p-values in closed form; leave it out");
}

/// Output of a study whose walls were shaken.
FragilityOutput shaken_output(const Command& command)
{
    IntensityData data =
        intensity_data(read_histories(command.study, command.overrides), command.intensity);
    if (!command.hazard.empty())
        data.hazard = hazard_points(read_csv_file(command.hazard), data);
    return intensity_output(data);
}

FragilityOutput output_of(const Command& command, const FitProgress& seen)
{
    const bool stored = is_study(command.study);
    if (stored) {
        Command columns = command;
        columns.intensity.clear(); // of histories it names a measure
        check_columns(columns, nullptr);
        if (holds_histories(read_head(command.study))) return shaken_output(command);
    }
    if (!command.hazard.empty())
        throw ConfigError("drystone", 0, "--hazard",
                          "gives an annual rate of walls that were shaken, and these were "
                          "not; leave it out");
    if (stored) {
        check_columns(command, nullptr);
        return study_output(read_study_walls(command.study, command.overrides), seen);
    }
    const DriftOptions options = options_of(command.overrides);
    const Csv csv = read_csv_file(command.study);
    check_columns(command, &csv);
    if (!command.intensity.empty()) {
        check_lognormal(command.overrides);
        return damage_output(
            damage_counts(csv, {command.intensity, command.failed, command.state, command.of}),
            options.confidence);
    }
    DriftData data = drift_data(csv, {command.drift, command.censored, command.group});
    data.options = options;
    return drift_output(std::move(data), seen);
}

} // namespace

void check_fragility(const Command& command)
{
    std::vector<fs::path> names = {"README.md", "fragility.json"};
    for (const char* const ending : kTableEndings)
        names.push_back(std::string("performance_limits") + ending);
    if (const std::string note = check_results(command.out, names); !command.quiet)
        std::cerr << note;
}

int fragility_command(const Command& command)
{
    refuse_study_file(command.study);
    check_fragility(command);
    catch_interrupts();
    Progress progress(std::cerr, stderr_progress(command.quiet), steady_seconds);
    const FragilityOutput output = output_of(command, [&](double done, const std::string& fit) {
        end_if_interrupted();
        progress.update(done, "testing the fit of " + fit);
    });
    progress.finish("tested all fits");
    const std::size_t removed = write_output(command.out, output);
    const std::size_t width = terminal_width();
    const std::string text = answers_text(output, command, width);
    std::cout << text;
    if (text.find("\u2020") != std::string::npos)
        std::cout << "\u2020: extrapolated: no wall was pushed this far.\n";
    const std::size_t told = command.report ? output.told_by_study : 0;
    std::cout << wrapped(output.remarks.substr(told), width) << "written to " << command.out
              << "; README.md there begins with these tables\n";
    if (removed > 0) std::cout << removed << " files of an earlier run were removed there\n";
    return 0;
}

} // namespace app
