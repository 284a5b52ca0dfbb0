#include "app/sheet/sheet_command.hpp"

#include "app/input/key_effects.hpp"
#include "app/input/keys/limit_state_text.hpp"
#include "app/input/study/material_presets.hpp"
#include "app/input/study_name.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/picture/chart_frame.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/picture/wall_svg.hpp"
#include "app/output/replaced_file.hpp"
#include "app/push/capacity_svg.hpp"
#include "app/push/hand_checks.hpp"
#include "app/push/pier_table.hpp"
#include "app/push/push_until_told.hpp"
#include "app/scene/scene_units.hpp"
#include "app/sheet/print_pdf.hpp"
#include "app/sheet/sheet_page.hpp"
#include "app/sheet/wall_drawing.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/other_way.hpp"
#include "app/study/pushed/drawn_wall.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/stored/wanted_walls.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/version.hpp"
#include "fragility/curve/drift.hpp"
#include "fragility/fits/observed_quantile.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace app {
namespace {

namespace fs = std::filesystem;

fs::path pdf_of(const fs::path& html) { return fs::path(html).replace_extension(".pdf"); }

/// A PDF is ours where the sheet beside it is.
void check_pdf(const fs::path& html)
{
    if (fs::exists(pdf_of(html)) && !fs::exists(html))
        throw ConfigError("drystone", 0, "--out",
                          "\"" + pdf_of(html).string() +
                              "\" is there, and no sheet beside it; write another name");
}

std::string subtitle(const Masonry& masonry, const PushedWall& w)
{
    std::string text = number(wall_length(masonry), 4) + " x " +
                       number(wall_height(masonry), 4) + " x " +
                       number(masonry.wall.thickness, 4) + " m";
    const MaterialPreset* const material =
        find_material(kMaterialNames.at(static_cast<std::size_t>(masonry.geometry.material)));
    if (material != nullptr) text += ", " + std::string(material->meaning);
    if (!masonry.beam.present) return text + ", without a load on its top";
    return text + ", " + stress_text(w.vertical_stress) + " of vertical stress on its top";
}

const dem::Snapshot& drop_or_end(const dem::PushResult& r)
{
    return r.at_drop ? *r.at_drop : r.at_end;
}

std::string end_name(const FragilityInput& fragility, const dem::PushResult& r)
{
    return r.at_drop ? "Just below " + percent_text(fragility.ultimate_share) + " of the peak"
                     : "At the end";
}

std::string mechanism_of(const dem::Beam& beam, const LoadInput& load,
                         const FragilityInput& fragility, const dem::Layout& layout,
                         const PushedWall& w)
{
    WallPictureText text;
    text.tints = stone_tints(layout);
    text.load_height = w.loads.height;
    if (beam.present) text.vertical_load = stress_text(w.vertical_stress);
    const dem::PushResult& r = w.result;
    if (const PushedWall* const other = other_way_of(w);
        other != nullptr && other->reading.peak) {
        const int direction = push_way(load).direction;
        text.peak_name = std::string("To the ") + way_name(direction);
        text.end_name = std::string("To the ") + way_name(-direction);
        return wall_picture(drop_or_end(r), drop_or_end(other->result), text);
    }
    const dem::Snapshot& peak = r.at_peak.blocks.empty() ? r.at_end : r.at_peak;
    if (!r.at_drop) return wall_picture(peak, r.at_end, text);
    text.end_name = end_name(fragility, r);
    return wall_picture(peak, *r.at_drop, text);
}

std::string drift_text(const fragility::ObservedQuantile& q)
{
    return q.value ? fixed(*q.value, 2) : ">";
}

/// "0.61, 1.39, 2.84": drifts of the random walls of a level [%].
std::string spread_of(const StudyLevel& level, std::size_t state, double height)
{
    constexpr std::array kShares = {0.16, 0.50, 0.84};
    std::vector<fragility::Observation> all;
    for (const StudyWall& w : level.walls)
        if (const auto o = fragility::observation(w.reading.limits.at(state),
                                                  fragility::percent_per_metre(height)))
            all.push_back(*o);
    if (all.empty()) return "";
    std::string text;
    for (const fragility::ObservedQuantile& q : fragility::observed_quantiles(all, kShares))
        text += (text.empty() ? "" : ", ") + drift_text(q);
    return text;
}

/// A limit displacement times `scale`, with two digits at least.
std::string sheet_limit(const fragility::LimitDisplacement& limit, double scale, int decimals)
{
    const int two_digits = decimals_for(limit.displacement * scale) - 1;
    return cell_text(limit_cell(limit, scale, std::max(decimals, two_digits)));
}

/// ", pushed to the left"
std::string ways_text(const std::string& way)
{
    return way == "both" ? ", pushed to either side" : ", pushed to the " + way;
}

/// The rule that governs, in a line where that can be.
std::string rule_of(const ReadingRules& rules, const PushedWall& w, const StateName& name,
                    std::size_t state, const fragility::LimitDisplacement& limit)
{
    constexpr std::string_view kGoverns = "governed by ";
    const std::string pier = pier_rule(rules, worse_push(w, state), name, state);
    const bool of_another = name.rule.starts_with("3/4") || name.rule.starts_with("2/3"),
               governed = limit.reason.starts_with(kGoverns);
    std::string rule = name.rule;
    if (!pier.empty() && !of_another) rule = pier;
    if (pier.empty() && governed && !of_another)
        rule = std::string(limit.reason.substr(kGoverns.size()));
    if (other_way_of(w) != nullptr)
        rule += ways_text(worse_way_name(rules.direction, w, state));
    if (pier.empty() && !governed && !limit.reason.empty())
        rule += "; here: " + std::string(limit.reason);
    return rule;
}

std::vector<SheetLimit> limits_of(ReadingRules rules, const PushedWall& w,
                                  const StudyLevel* stored)
{
    rules.by_piers = !w.piers.empty();
    const std::vector<StateName> names = state_names(rules);
    const WallReading worse = worse_way(w);
    std::vector<SheetLimit> all;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const fragility::LimitDisplacement& limit = worse.limits.at(i);
        SheetLimit row{state_name(names[i]), sheet_limit(limit, 1e3, 1),
                       sheet_limit(limit, fragility::percent_per_metre(w.loads.height), 2),
                       rule_of(rules, w, names[i], i, limit), ""};
        if (stored != nullptr) row.spread = spread_of(*stored, i, w.loads.height);
        all.push_back(std::move(row));
    }
    return all;
}

/// The wall of the study's numbers, each random value its mean.
std::vector<WantedWall> mean_wall(const StudySource& source, const Command& command)
{
    const Study& study = source.ready.study;
    const bool mean =
        study.uq.drawn.empty() && (!study.random.empty() || has_layouts(study.geometry));
    if (study.uq.drawn.empty())
        static_cast<void>(level_of(study.load, command.level)); // one wall alone
    return wanted_walls(source, {command.sample, command.mean_wall || mean, command.level});
}

std::string title_of(const Command& command)
{
    return command.title.empty() ? study_title(command.study) : command.title;
}

Sheet sheet_of(const Study& study, const dem::Layout& layout, const PushedWall& w,
               const StudyWalls* stored, int level, const Command& command)
{
    const StudyLevel* const walls =
        stored == nullptr ? nullptr : &stored->levels.at(static_cast<std::size_t>(level));
    const ReadingRules rules = reading_rules(study);
    Sheet s;
    s.title = title_of(command);
    s.subtitle = subtitle(study, w);
    s.answer = answer_sentences(study.load, study.fragility,
                                hand_checks(study, layout, w).vertical_load, w);
    s.moves = moving_part(study.load);
    s.drift_words = drift_words(study.load);
    s.drawing = wall_drawing(scene_units(study.geometry, whole_units(study, study.source)),
                             330.0, 250.0);
    s.curve = line_chart(sheet_curve(rules, w));
    s.mechanism = mechanism_of(study.beam, study.load, study.fragility, layout, w);
    s.limits = limits_of(rules, w, walls);
    if (walls != nullptr)
        s.spread_head = "drift [%] of 16, 50, 84 % of " + std::to_string(walls->walls.size()) +
                        " random walls";
    s.piers = pier_paragraphs(rules, w);
    s.assumed = assumptions(study, 4);
    s.certainty = certainty_sentences(study, w, stored, static_cast<std::size_t>(level));
    s.footer = "Drystone " + std::string(kVersion) + ", in-plane push of " +
               fs::path(command.study).filename().string() +
               ". A help for the engineer, who answers for it; not for out-of-plane failure "
               "nor for shaking in time.";
    return s;
}

} // namespace

Chart sheet_curve(const ReadingRules& rules, const PushedWall& wall)
{
    Chart curve = capacity_chart(rules, wall);
    constexpr double kLeast = 300.0, kMost = 400.0; // [px]
    curve.title = "";
    curve.width = 680.0;
    curve.height = kLeast;
    // A key of many limits takes its rows from the page, not from the plot.
    const ChartFrame frame = lay_out_chart(curve);
    if (frame.legend.empty()) return curve;
    const double rows = frame.legend.back().at.y - frame.legend.front().at.y;
    const bool numbered = frame.legend.back().number > 0;
    curve.height = std::min(kMost, kLeast + rows + (numbered ? kNumberRow : 0.0));
    return curve;
}

int sheet_command(const Command& command)
{
    if (is_study_name(command.study)) check_is_study(command.study);
    const StudySource source = study_source(command.study, command.overrides);
    const Study& study = source.ready.study;
    const std::vector<WantedWall> wanted = mean_wall(source, command);
    if (const std::string note = check_replaced(command.out, kSheetMark); !command.quiet)
        std::cerr << note;
    check_pdf(command.out);
    std::optional<StudyWalls> stored;
    if (is_study_name(command.study))
        stored = read_study_walls(command.study, command.overrides, Keep::readings);
    std::cerr << wrapped(study_notes(source.ready, command.verb), terminal_width());
    catch_interrupts();
    dem::PushPlan plan = push_plan(study);
    plan.snapshot_every = 0.0;
    const Pushed pushed =
        push_until_told(source.ready, std::move(plan), wanted, command.threads, command.quiet);
    if (!pushed.whole) throw Interrupted{"no sheet was written"};
    const PushedWall& wall = pushed.walls.front();
    if (dem::failed(wall.result.outcome))
        throw std::runtime_error("the wall failed, and has no sheet: " +
                                 wall.reading.no_reading);
    const Study used = study.random.empty() ? study : with_drawn(study, wanted.front());
    const fs::path out = command.out;
    if (out.has_parent_path()) make_folder(out.parent_path());
    const Sheet sheet = sheet_of(used, source.ready.layout, wall, stored ? &*stored : nullptr,
                                 wanted.front().level, command);
    write_file(out, sheet_page(sheet));
    for (const std::string& s : sheet.answer) std::cout << wrapped(s + "\n", terminal_width());
    std::cout << out.string() << " written\n"
              << wrapped(print_pdf(out, pdf_of(out)) + "\n", terminal_width());
    return 0;
}

} // namespace app
