#include "app/sheet/sheet_page.hpp"

#include "app/output/svg_elements.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace app {
namespace {

constexpr std::string_view kStyle = R"(
@page { size: A4 portrait; margin: 0 }
* { box-sizing: border-box }
html { background: #ddd }
body { margin: 0; font: 8.4pt/1.32 "DejaVu Sans", Verdana, Arial, sans-serif; color: #222 }
main { position: relative; width: 210mm; height: 296mm; margin: 0 auto; background: white; overflow: hidden }
section { position: absolute; overflow: hidden }
h1 { font-size: 15pt; margin: 0 0 0.6mm 0; line-height: 1.15 }
h2 { font-size: 9.6pt; margin: 0 0 1mm 0; color: #0b4f7d }
p { margin: 0 0 0.8mm 0 }
ul { margin: 0; padding-left: 3.6mm }
li { margin-bottom: 0.9mm }
table { border-collapse: collapse; width: 100% }
table { font-size: 7.6pt; line-height: 1.2 }
th, td { text-align: left; padding: 0.45mm 3mm 0.5mm 0; border-bottom: 0.2mm solid #bbb; vertical-align: top; white-space: nowrap }
td.rule { white-space: normal }
th.spread { white-space: normal; width: 34mm }
td.n, th.n { text-align: right }
.sub { color: #555 }
.answer { font-size: 10.2pt; line-height: 1.35 }
.small { font-size: 7.2pt; line-height: 1.28; color: #444 }
code { font-family: "DejaVu Sans Mono", monospace; font-size: 7.4pt }
svg { display: block; margin: 0 auto }
@media screen { main { margin: 6mm auto; box-shadow: 0 0 4mm #888 } }
)";

std::string box(double left, double top, double width, double height, const std::string& body)
{
    const auto mm = [](double x) { return number(x, 5) + "mm;"; };
    return "<section style=\"left:" + mm(left) + "top:" + mm(top) + "width:" + mm(width) +
           "height:" + mm(height) + "\">" + body + "</section>\n";
}

/// The number behind `name="` in the first tag.
double attribute(const std::string& svg, const std::string& name)
{
    const std::size_t at = svg.find(" " + name + "=\"");
    return at == std::string::npos ? 1.0
                                   : std::strtod(svg.c_str() + at + name.size() + 3, nullptr);
}

/// The picture as large as it can be within a width and a height [mm].
std::string fitted_picture(std::string svg, double width, double height)
{
    const double w = attribute(svg, "width"), h = attribute(svg, "height");
    const double scale = std::min(width / w, height / h);
    const std::size_t from = svg.find(" width=\""), to = svg.find(" viewBox=\"");
    if (from == std::string::npos || to == std::string::npos || to < from) return svg;
    return svg.replace(from, to - from,
                       " width=\"" + svg_number(scale * w) + "mm\" height=\"" +
                           svg_number(scale * h) + "mm\"");
}

std::string heading(const std::string& text) { return "<h2>" + xml_escape(text) + "</h2>"; }

std::string head(const Sheet& s)
{
    std::string body = "<h1>" + xml_escape(s.title) + "</h1><p class=\"sub\">" +
                       xml_escape(s.subtitle) + "</p><p class=\"answer\">";
    for (const std::string& a : s.answer) body += xml_escape(a) + " ";
    return body + "</p>";
}

std::string limit_row(const SheetLimit& l, bool spread)
{
    return "<tr><td>" + xml_escape(l.state) + "</td><td class=\"n\">" +
           xml_escape(l.displacement) + "</td><td class=\"n\">" + xml_escape(l.drift) +
           "</td>" + (spread ? "<td class=\"n\">" + xml_escape(l.spread) + "</td>" : "") +
           "<td class=\"rule\">" + xml_escape(l.rule) + "</td></tr>";
}

std::string limits_table(const Sheet& s)
{
    const bool spread = !s.spread_head.empty();
    std::string body =
        heading("Limits, and the rule that governs each") +
        "<table><tr><th>limit state</th><th class=\"n\">top moves [mm]</th><th "
        "class=\"n\">drift [%]</th>" +
        (spread ? "<th class=\"n spread\">" + xml_escape(s.spread_head) + "</th>" : "") +
        "<th>rule</th></tr>";
    const std::size_t shown = std::min(s.limits.size(), kMostSheetLimits);
    for (std::size_t i = 0; i < shown; ++i) body += limit_row(s.limits[i], spread);
    if (shown < s.limits.size())
        body += "<tr><td colspan=\"5\">and " + std::to_string(s.limits.size() - shown) +
                " more, which push writes to limit_states.md</td></tr>";
    body +=
        "</table><p class=\"small\">Drift: how far the top moves sideways, in percent of the "
        "height of the load. &gt;: not reached when the push ended.</p>";
    for (const std::string& text : s.piers)
        body += "<p class=\"small\">" + xml_escape(text) + "</p>";
    return body;
}

/// Height that the picture of the mechanism can give up for a longer table [mm].
constexpr double kGivenUp = 19.0;

/// Height of the paragraphs on piers [mm].
double piers_height(const Sheet& s)
{
    constexpr double kLine = 3.4;
    constexpr std::size_t kInLine = 135; // characters
    std::size_t lines = 0;
    for (const std::string& text : s.piers) lines += 1 + text.size() / kInLine;
    return kLine * static_cast<double>(lines);
}

/// Height of the box of the table [mm]: rules that are long take two lines.
double table_height(const Sheet& s)
{
    constexpr double kLine = 4.3, kFurther = 3.2, kHead = 17.0, kMost = 76.0 + kGivenUp;
    const std::size_t in_line = s.spread_head.empty() ? 95 : 58; // characters
    std::size_t further = s.spread_head.empty() ? 0 : 1;         // lines within a row
    const std::size_t shown = std::min(s.limits.size(), kMostSheetLimits),
                      rows = shown + (s.limits.size() > shown ? 1 : 0);
    for (std::size_t i = 0; i < shown; ++i) further += s.limits[i].rule.size() / in_line;
    return std::min(kMost, kHead + kLine * static_cast<double>(rows) +
                               kFurther * static_cast<double>(further) + piers_height(s));
}

std::string assumed_list(const Sheet& s)
{
    std::string body =
        heading("What was assumed, and how much it mattered where it was measured") + "<ul>";
    for (const Assumption& a : s.assumed)
        body += "<li><code>" + xml_escape(a.what) + "</code>: " + xml_escape(a.meaning) +
                (a.how_much.empty() ? "" : ". <i>" + xml_escape(a.how_much) + "</i>") +
                ".</li>";
    return body + "</ul><p>drystone choices shows what each of them does to this wall.</p>";
}

std::string certainty_list(const Sheet& s)
{
    std::string body = heading("How sure is this?") + "<ul>";
    for (const std::string& text : s.certainty) body += "<li>" + xml_escape(text) + "</li>";
    return body + "</ul>";
}

} // namespace

std::string sheet_page(const Sheet& s)
{
    constexpr double kLeft = 12.0, kWide = 186.0; // [mm]
    constexpr double kHalf = 91.0, kRight = 107.0;
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" +
        std::string(kSheetMark) + "\n<title>" + xml_escape(s.title) + "</title>\n<style>" +
        std::string(kStyle) + "</style>\n</head>\n<body>\n<main>\n";
    // The height of the table follows its rows; the lists below take what is left.
    const double limits = table_height(s), given_up = std::clamp(limits - 76.0, 0.0, kGivenUp),
                 table = 168.0 - given_up, lists = table + limits;
    page += box(kLeft, 9.0, kWide, 31.0, head(s));
    page += box(kLeft, 41.0, 66.0, 58.0,
                heading("The wall") + fitted_picture(s.drawing, 66.0, 52.0));
    page += box(80.0, 41.0, 118.0, 58.0,
                heading("Force over movement of the top, with all limits") +
                    fitted_picture(s.curve, 118.0, 52.0));
    page += box(kLeft, 100.0, kWide, 67.0 - given_up,
                heading("How it moves and fails") +
                    fitted_picture(s.mechanism, kWide, 61.0 - given_up));
    page += box(kLeft, table, kWide, limits, limits_table(s));
    page += box(kLeft, lists, kHalf, 287.0 - lists,
                "<div class=\"small\">" + assumed_list(s) + "</div>");
    page += box(kRight, lists, kHalf, 287.0 - lists,
                "<div class=\"small\">" + certainty_list(s) + "</div>");
    page +=
        box(kLeft, 288.0, kWide, 5.0, "<p class=\"small\">" + xml_escape(s.footer) + "</p>");
    return page + "</main>\n</body>\n</html>\n";
}

} // namespace app
