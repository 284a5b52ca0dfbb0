#include "app/commands.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/study_name.hpp"
#include "app/input/study_reading.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/picture/wall_svg.hpp"
#include "app/output/progress.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/series_folder.hpp"
#include "app/output/table/table.hpp"
#include "app/output/unique_names.hpp"
#include "app/shake/shake_files.hpp"
#include "app/shake/shake_wall.hpp"
#include "app/shake/shaken_film.hpp"
#include "app/shake/shaking_motions.hpp"
#include "app/study/pushed/drawn_wall.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "fragility/curve/drift.hpp"

#include <deque>
#include <filesystem>
#include <iostream>
#include <optional>

namespace app {
namespace {

constexpr std::string_view kShakeList = "drystone_shake_files.txt";

Table shaken_table(const std::vector<ShakenWall>& walls)
{
    Table t;
    t.title = "Shaken wall";
    t.head = {"record", "PGA [g]", "max drift [%]", "residual [%]", "fell"};
    for (const ShakenWall& w : walls) {
        const dem::ShakeResult& r = w.result;
        const bool failed = shake_failed(r), fell = r.outcome == dem::ShakeOutcome::collapsed;
        const auto drift = [&](double x) {
            return Number{.value = fragility::percent_drift(x, r.top_height), .decimals = 3};
        };
        t.rows.push_back({w.motion.name, Number{.value = peak_ground_g(w), .decimals = 3},
                          failed ? Number{} : drift(r.most_displacement),
                          failed || fell ? Number{} : drift(r.residual_displacement),
                          std::string(failed         ? "failed"
                                      : r.overturned ? "overturned"
                                      : fell         ? "yes"
                                                     : "no")});
    }
    return t;
}

std::string shaken_picture(const PreparedStudy& ready, const ShakenWall& w)
{
    WallPictureText text;
    text.pushed = false;
    text.title = w.motion.name;
    text.tints = stone_tints(ready.layout);
    if (ready.study.beam.present) text.vertical_load = stress_text(w.vertical_stress);
    text.load_height = w.result.top_height;
    text.both_name = text.end_name;
    return wall_picture(w.result.at_end, w.result.at_end, text);
}

/// The wall along its history, for ParaView.
void add_series(const ShakenWall& w, SeriesFolder& series, const std::filesystem::path& folder,
                std::vector<OutputFile>& moved)
{
    for (std::size_t i = 0; i < w.result.snapshots.size(); ++i)
        series.add_at(w.result.snapshot_times[i], w.result.snapshots[i]);
    if (series.empty()) return;
    for (OutputFile& f : series.seal())
        moved.push_back({folder / f.name, {}, std::move(f.from)});
}

} // namespace

int shake_command(const Command& command)
{
    if (is_study_name(command.study))
        throw ConfigError(command.study, 0, "", "shake reads a study file; give STUDY.ini");
    if (!command.video.empty())
        throw ConfigError("drystone", 0, "--film",
                          "shake writes film.svg; leave out " + in_quotes(command.video));
    const StudySource source = study_source(command.study, command.overrides);
    const std::vector<ShakingMotion> motions =
        shaking_motions(source.ready.study.shaking, source.ready.study.source);
    const std::vector<WantedWall> wanted =
        wanted_walls(source, {command.sample, command.mean_wall, command.level});
    const PreparedStudy ready = shaken_study(source.ready, command.sample.value_or(0));
    const Study& study = ready.study;
    if (wanted.size() != 1) static_cast<void>(level_of(study.load, command.level)); // throws
    const WantedWall& wall = wanted.front();
    std::vector<std::filesystem::path> folders, names;
    UniqueNames unique;
    for (const ShakingMotion& m : motions) {
        folders.emplace_back(motions.size() == 1
                                 ? std::string()
                                 : std::string(unique.add(plain_name(m.name, "motion"))));
        for (const char* const name : {"study.ini", "summary.json", "history.csv",
                                       "history.svg", "wall.svg", "film.svg"})
            names.push_back(folders.back() / name);
    }
    // A series is large: it is written where the study asks for it in so many words.
    const bool series = study.output.paraview && is_given(study.source, "output.paraview");
    std::deque<SeriesFolder> folders_of_series;
    for (const std::filesystem::path& folder : folders) {
        if (!series) break;
        const std::filesystem::path place =
            std::filesystem::path(command.out) / folder / "series";
        for (const std::filesystem::path& file : in_the_way_of_series(place))
            names.push_back(file.lexically_relative(command.out));
        folders_of_series.emplace_back(place);
    }
    std::cerr << study_notes(ready, command.verb);
    if (const std::string note = check_results(command.out, names, kShakeList); !command.quiet)
        std::cerr << note;
    catch_interrupts();
    const Study used = study.random.empty() ? study : with_drawn(study, wall);
    const std::string text = effective_configuration(used);
    std::vector<ShakenWall> walls;
    std::vector<OutputFile> files, moved;
    std::optional<Progress> progress;
    const auto seen = [&](const ShakingMotion& m, double done, double top) {
        end_if_interrupted();
        if (!progress)
            progress.emplace(std::cerr, stderr_progress(command.quiet), steady_seconds);
        progress->update(done, m.name + ", " + fixed(top * 1e3, 1) + " mm");
    };
    shake_wall(ready, wall, motions, command.film || series ? kShakenFrame : 0.0, seen,
               [&](ShakenWall&& shaken) {
                   if (progress) progress->finish(shaken.motion.name);
                   progress.reset();
                   const bool failed = shake_failed(shaken.result);
                   const std::string picture = failed ? "" : shaken_picture(ready, shaken);
                   const std::string film =
                       failed || !command.film ? ""
                                               : shaken_film(shaken, stone_tints(ready.layout));
                   for (OutputFile& f : shake_files(shaken, text, picture, film))
                       files.push_back({folders[walls.size()] / f.name, std::move(f.content)});
                   if (series)
                       add_series(shaken, folders_of_series[walls.size()],
                                  folders[walls.size()], moved);
                   shaken.result.snapshots.clear();
                   walls.push_back(std::move(shaken));
               });
    files.insert(files.end(), moved.begin(), moved.end());
    write_results(command.out, files, kShakeList);
    std::cout << as_text(shaken_table(walls), terminal_width())
              << "verified against closed forms, not validated\nwritten to " << command.out
              << '\n';
    bool failed = false;
    for (const ShakenWall& w : walls) {
        if (!shake_failed(w.result)) continue;
        failed = true;
        std::cerr << "drystone: " << w.motion.name
                  << ": the wall failed: " << dem::name_of(w.result.outcome) << '\n';
    }
    return failed ? 1 : 0;
}

} // namespace app
