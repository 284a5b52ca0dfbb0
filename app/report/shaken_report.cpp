#include "app/report/shaken_report.hpp"

#include "app/fragility/intensity/intensity_output.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/report/report_bytes.hpp"
#include "app/report/report_page.hpp"
#include "app/shake/shake_again.hpp"
#include "app/shake/shaken_film.hpp"
#include "app/study/pushed/drawn_wall.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <optional>
#include <vector>

namespace app {
namespace {

constexpr const char* kShakenStyle =
    "body{margin:0 auto;max-width:72rem;padding:1rem;font:16px/1.5 system-ui,sans-serif;"
    "color:#1d2326;background:#fbfaf7}"
    "figure{margin:0}figcaption{color:#5c6266;font-size:.9rem}"
    "img{display:block;width:100%;background:#fff;border:1px solid #ddd8cc;border-radius:6px}"
    ".films{display:grid;gap:1rem}"
    ".pictures{display:grid;gap:1rem;grid-template-columns:repeat(auto-fill,minmax(min(22rem,"
    "100%),1fr))}"
    "details{margin:.6rem 0}summary{cursor:pointer;font-weight:600}"
    ".scroll{overflow-x:auto}table{border-collapse:collapse;font-size:.85rem}"
    "th,td{padding:.2rem .6rem;text-align:right;border-bottom:1px solid #ddd8cc;"
    "white-space:nowrap}"
    "@media (prefers-color-scheme:dark){body{color:#e8e6e1;background:#14181b}"
    "figcaption{color:#a3a8ab}img{border-color:#333}th,td{border-color:#333}}";

std::string picture_html(const std::string& svg, const std::string& caption)
{
    const std::vector<std::uint8_t> bytes(svg.begin(), svg.end());
    return "<figure><img src=\"data:image/svg+xml;base64," + base64(bytes) + "\" alt=\"" +
           html_text(caption) + "\"><figcaption>" + html_text(caption) +
           "</figcaption></figure>\n";
}

std::string row_html(const std::vector<std::string>& cells, const char* kind)
{
    std::string text = "<tr>";
    for (const std::string& cell : cells)
        text += std::string("<") + kind + ">" + html_text(cell) + "</" + kind + ">";
    return text + "</tr>\n";
}

std::string table_html(const NamedTable& named)
{
    const ShownTable t = shown(named.table);
    std::string text = std::string("<details") + (named.answer ? " open" : "") + "><summary>" +
                       html_text(named.table.title) + "</summary>\n<p>" +
                       html_text(named.table.caption) + "</p>\n<div class=\"scroll\"><table>" +
                       row_html(t.head, "th");
    for (const auto& row : t.rows) text += row_html(row, "td");
    text += "</table></div>\n";
    for (const std::string& note : t.notes) text += "<p>" + html_text(note) + "</p>\n";
    return text + "</details>\n";
}

/// The history that went farthest and stood, else one that fell.
const StoredHistory* farthest(const HistoryLevel& level)
{
    const StoredHistory* best = nullptr;
    for (const StoredHistory& h : level.histories) {
        if (h.failed) continue;
        const bool better = best == nullptr || (best->fell && !h.fell) ||
                            (best->fell == h.fell && h.max_drift > best->max_drift);
        if (better) best = &h;
    }
    return best;
}

std::string film_caption(const StoredHistories& stored, std::size_t level,
                         const StoredHistory& h, const ShakenWall& wall)
{
    return stress_text(stored.levels[level].stress) + ": wall " + std::to_string(h.wall) +
           " under " + wall.motion.name + ", " +
           (h.fell ? "which fell"
                   : "largest drift of those that stood, " + number(100.0 * h.max_drift, 3) +
                         " %");
}

struct Films {
    std::vector<ReportFilm> all;
    std::string note;
};

Films films_of(const StoredHistories& stored, const std::filesystem::path& file, bool quiet)
{
    Films films;
    std::optional<ShakenAgain> again;
    try {
        again.emplace(stored, file);
    } catch (const ConfigError& gone) {
        films.note = std::string("No films: ") + gone.what();
        return films;
    }
    Progress progress(std::cerr, stderr_progress(quiet), steady_seconds);
    const auto levels = static_cast<double>(stored.levels.size());
    std::size_t different = 0;
    for (std::size_t l = 0; l < stored.levels.size(); ++l) {
        const StoredHistory* const h = farthest(stored.levels[l]);
        if (h == nullptr) continue;
        const ShakenWall wall =
            again->history(l, *h, [&](const ShakingMotion& m, double done, double) {
                end_if_interrupted();
                progress.update((static_cast<double>(l) + done) / levels, m.name);
            });
        const double drift = wall.result.most_displacement / wall.result.top_height;
        different += drift == h->max_drift ? 0 : 1;
        films.all.push_back({film_caption(stored, l, *h, wall),
                             shaken_film(wall, stone_tints(again->study_of(*h).layout))});
    }
    progress.finish("films");
    if (different > 0)
        films.note = std::to_string(different) +
                     " of the films differ from what is stored: the file was written by "
                     "another version of the program.";
    return films;
}

} // namespace

std::string shaken_page(const std::string& title, const FragilityOutput& output,
                        std::span<const ReportFilm> films, const std::string& note)
{
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" +
        std::string(kPageMark) +
        "\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src "
        "data:; style-src 'unsafe-inline'\">\n<title>" +
        html_text(title) + "</title>\n<style>" + kShakenStyle +
        "</style>\n</head>\n<body>\n<h1>" + html_text(title) + "</h1>\n<p>" +
        html_text(output.source) +
        ". Shaking is verified against closed forms, not validated: no open test of a "
        "dry-joint wall that is shaken in its plane is known.</p>\n";
    if (!output.remarks.empty()) text += "<p>" + html_text(output.remarks) + "</p>\n";
    if (!films.empty() || !note.empty()) text += "<h2>Films, in real time</h2>\n";
    if (!note.empty()) text += "<p>" + html_text(note) + "</p>\n";
    text += "<div class=\"films\">\n";
    for (const ReportFilm& film : films) text += picture_html(film.svg, film.caption);
    text += "</div>\n<h2>Pictures</h2>\n<div class=\"pictures\">\n";
    for (const NamedPicture& p : output.pictures) text += picture_html(p.svg, p.title);
    text += "</div>\n<h2>Tables</h2>\n";
    for (const NamedTable& t : output.tables) text += table_html(t);
    return text + "</body>\n</html>\n";
}

int shaken_report_command(const Command& command)
{
    const std::filesystem::path file = command.words.front(), out = command.out;
    StoredHistories stored = read_histories(file, command.overrides);
    const Films films = films_of(stored, file, command.quiet);
    const std::string title =
        command.title.empty() ? "Drystone study " + file.stem().string() : command.title;
    const std::string page = shaken_page(
        title, intensity_output(intensity_data(std::move(stored), "")), films.all, films.note);
    if (out.has_parent_path()) make_folder(out.parent_path());
    write_file(out, page);
    if (!films.note.empty()) std::cout << wrapped(films.note + "\n", terminal_width());
    std::cout << "written to " << out.string() << ", "
              << fixed(static_cast<double>(page.size()) * 1e-6, 1) << " MB\n";
    return 0;
}

} // namespace app
