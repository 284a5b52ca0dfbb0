#include "app/compare/compared.hpp"

#include "app/compare/compared_limits.hpp"
#include "app/compare/measured.hpp"
#include "app/input/study_name.hpp"
#include "app/output/picture/chart_svg.hpp"
#include "app/output/table/cells.hpp"
#include "app/push/test_curve.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/answers/mean_cells.hpp"
#include "app/study/answers/mode_share.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/config_error.hpp"
#include "app/text/json_text.hpp"
#include "app/text/number_text.hpp"
#include "app/text/text_file.hpp"
#include "fragility/curve/drift.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace app {
namespace {

namespace fs = std::filesystem;

/// Mean of the walls as far as nine tenths of them go.
void add_mean_curve(Compared& c, const StudyLevel& level, double step)
{
    constexpr double kGoOn = 0.9;
    const auto walls = static_cast<double>(level.walls.size());
    for (std::size_t i = 0;; ++i) {
        double sum = 0.0, n = 0.0;
        for (const StudyWall& w : level.walls)
            if (i < w.forces.size()) sum += w.forces[i], n += 1.0;
        if (n == 0.0 || n < kGoOn * walls) return;
        c.displacement.push_back(static_cast<double>(i) * step);
        c.force.push_back(sum / n);
    }
}

std::string modes_text(const StudyWalls& study, const StudyLevel& level)
{
    std::string text;
    for (const int mode : modes_of(study))
        text +=
            (text.empty() ? "" : ", ") + std::string(mode_name(mode)) + " " +
            fixed(100.0 * mode_share(level, mode, study.study.fragility.confidence).value, 0) +
            " %";
    return text;
}

Compared of_level(const StudyWalls& study, const StudyLevel& level)
{
    Compared c;
    std::vector<double> peaks, places, stiffness;
    std::vector<fragility::Observation> limits, drifts;
    for (const StudyWall& w : level.walls) {
        if (!w.reading.peak) continue;
        peaks.push_back(peak_force(w.reading));
        places.push_back(peak_displacement(w.reading));
        if (w.reading.stiffness) stiffness.push_back(*w.reading.stiffness);
        if (const auto o = fragility::observation(w.reading.ultimate, 1e3))
            limits.push_back(*o);
        if (const auto o = fragility::observation(w.reading.ultimate,
                                                  fragility::percent_per_metre(study.height)))
            drifts.push_back(*o);
    }
    const double confidence = study.study.fragility.confidence;
    c.name = study.name;
    c.stress = level.stress;
    for (const double p : peaks) c.peak = (std::isnan(c.peak) ? 0.0 : c.peak) + p;
    c.peak /= static_cast<double>(std::max<std::size_t>(peaks.size(), 1));
    c.cells = {stress_cell(level.stress),          count(level.walls.size()),
               mean_cell(peaks, 2, 1e-3),          mean_cell(places, 2, 1e3),
               mean_cell(stiffness, 1, 1e-6),      median_cell(limits, confidence, 1),
               median_cell(drifts, confidence, 2), modes_text(study, level)};
    add_mean_curve(c, level, study.step);
    return c;
}

std::vector<Compared> of_study(const std::string& path)
{
    check_is_study(path);
    const StudyWalls study = read_study_walls(path);
    std::vector<Compared> all;
    for (const StudyLevel& level : study.levels) all.push_back(of_level(study, level));
    return all;
}

/// As summary.json has it, by its present key or that of earlier versions.
Number shown_in(const Json& json, const WallNumber& n)
{
    auto x = number_in(json, summary_key(n));
    if (!x && !n.old_key.empty()) x = number_in(json, std::string(n.old_key));
    return x ? plain_number(*x, n.decimals) : Number{};
}

Number limit_in(const Json& j, double scale, int decimals)
{
    const auto limit = number_in(j, "ultimate_displacement_mm");
    if (!limit) return {};
    Number n = plain_number(*limit * scale, decimals);
    const auto censored = j.find("ultimate_censored");
    if (censored != j.end() && censored->is_boolean() && censored->get<bool>())
        n.sense = Sense::above;
    return n;
}

Compared of_push(const fs::path& folder)
{
    const std::string path = (folder / "summary.json").string();
    constexpr std::size_t kMost = std::size_t{4} << 20;
    if (!fs::exists(path))
        throw ConfigError(
            folder.string(), 0, "",
            "has no summary.json; give the folder of one push (of several stresses: "
            "one of the folders in it), a FILE.h5 or a .csv");
    Json j;
    try {
        j = json_of(
            read_bytes(path, kMost, "is larger than 4 MiB", "give the folder of a push"));
    } catch (const Json::exception&) {
        throw ConfigError(path, 0, "", "is not the summary of a push; push the wall again");
    }
    if (!j.contains(summary_key(wall_number("peak_force"))))
        throw ConfigError(path, 0, "",
                          "is not the summary of a push, such as that of a wall that was "
                          "shaken; give the folder of a push");
    Compared c;
    c.name = folder.filename().empty() ? folder.parent_path().filename().string()
                                       : folder.filename().string();
    if (const auto stress = number_in(j, "vertical_stress_MPa")) c.stress = *stress * 1e6;
    if (const auto peak = number_in(j, "peak_force_kN")) c.peak = *peak * 1e3;
    const double height = number_in(j, "load_height_m").value_or(kUnknown);
    const auto mode = j.find("mode");
    c.cells = {std::isnan(c.stress) ? Number{} : stress_cell(c.stress),
               count(1),
               shown_in(j, wall_number("peak_force")),
               shown_in(j, wall_number("peak_displacement")),
               shown_in(j, wall_number("secant_stiffness")),
               limit_in(j, 1.0, 1),
               std::isnan(height) ? Number{}
                                  : limit_in(j, 1e-3 * fragility::percent_per_metre(height), 2),
               mode != j.end() && mode->is_string() ? mode->get<std::string>() : std::string()};
    if (fs::exists(folder / "capacity.csv")) {
        const TestCurve curve = read_test_curve((folder / "capacity.csv").string());
        c.displacement = curve.displacement;
        c.force = curve.force;
    }
    return c;
}

std::string line_name(const Compared& c)
{
    return std::isnan(c.stress) ? c.name : c.name + ", " + stress_text(c.stress);
}

/// Work of the horizontal force along the whole path [J].
double work_of(const Compared& c)
{
    double work = 0.0;
    for (std::size_t i = 1; i < c.force.size(); ++i)
        work +=
            0.5 * (c.force[i - 1] + c.force[i]) * (c.displacement[i] - c.displacement[i - 1]);
    return work;
}

/// The wall to whose peak another is related.
const Compared& reference(const std::vector<Compared>& all, const Compared& c)
{
    for (const Compared& first : all)
        if (first.stress == c.stress) return first;
    return all.front();
}

} // namespace

bool goes_to_and_fro(const Compared& c)
{
    double farthest = 0.0, least = 0.0, most = 0.0, back_from_most = 0.0, back_from_least = 0.0;
    for (const double u : c.displacement) {
        farthest = std::max(farthest, std::abs(u));
        least = std::min(least, u);
        most = std::max(most, u);
        back_from_most = std::max(back_from_most, most - u);
        back_from_least = std::max(back_from_least, u - least);
    }
    return std::min(back_from_most, back_from_least) > kNoise * farthest;
}

std::vector<Compared> read_compared(const std::string& path)
{
    if (is_study_name(path)) return of_study(path);
    const fs::path folder = path;
    if (fs::exists(folder / kFragilityFile) && !fs::exists(folder / "summary.json")) return {};
    if (fs::is_directory(path)) return {of_push(path)};
    if (is_measured(path) && fs::exists(path)) return {read_measured(path)};
    if (!fs::exists(path)) throw ConfigError(path, 0, "", "there is no such file or folder");
    throw ConfigError(
        path, 0, "",
        "cannot be compared; give a FILE.h5, the folder of a push or of fragility, or a .csv, "
        ".txt or .tsv with displacement_mm,force_kN");
}

Table compared_table(const std::vector<Compared>& all)
{
    Table t;
    t.title = "Walls side by side";
    t.caption =
        "Of a study: means with their standard errors, and of the ultimate displacement the "
        "median "
        "with its interval. Ultimate: where the force is down to the share of the peak that "
        "each "
        "was read with, 80 % unless fragility.ultimate_share says another. The last column "
        "relates peaks to the first wall under the same stress, else to the first of all.";
    t.keys = 2;
    t.head = {"wall",
              "stress [MPa]",
              "walls",
              number_head(wall_number("peak_force"), kError),
              number_head(wall_number("peak_displacement"), kError),
              number_head(wall_number("secant_stiffness"), kError),
              number_head(wall_number("ultimate_displacement"), kInterval | kCensored),
              number_head(wall_number("ultimate_drift"), kInterval | kCensored),
              "mode"};
    const bool cyclic = std::ranges::any_of(all, goes_to_and_fro);
    if (cyclic) {
        t.caption +=
            " A measured curve to and fro is read on the mean of the envelopes of both "
            "sides, as far as both reach; its stiffness is that of the side loaded "
            "first. The work is that of the horizontal force along the whole path; cycles "
            "take it up.";
        t.head.emplace_back("work [J]");
    }
    t.head.emplace_back("peak to the first [%]");
    for (const Compared& c : all) {
        const double base = reference(all, c).peak;
        Row row = joined({c.name}, c.cells);
        if (cyclic)
            row.emplace_back(goes_to_and_fro(c) ? plain_number(work_of(c), 0) : Number{});
        row.emplace_back(std::isfinite(c.peak) && base > 0.0
                             ? plain_number(100.0 * (c.peak / base - 1.0), 1)
                             : Number{});
        t.rows.push_back(std::move(row));
    }
    return t;
}

std::string compared_chart(const std::vector<Compared>& all)
{
    Chart chart;
    chart.title = "Force over displacement";
    chart.x_label = "Displacement [mm]";
    chart.y_label = "Horizontal force [kN]";
    for (const Compared& c : all) {
        Series line;
        line.name = line_name(c);
        for (std::size_t i = 0; i < c.force.size(); ++i) {
            line.x.push_back(c.displacement[i] * 1e3);
            line.y.push_back(c.force[i] * 1e-3);
        }
        if (c.measured) line.line = LineStyle::dashed;
        if (!line.x.empty()) chart.series.push_back(std::move(line));
    }
    return line_chart(chart);
}

} // namespace app
