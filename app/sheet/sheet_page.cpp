#include "app/sheet/sheet_page.hpp"

#include "app/output/picture/svg_elements.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace app {
namespace {

constexpr std::string_view kStyle = R"(
@page { size: A4 portrait; margin: 0 }
* { box-sizing: border-box }
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
@media screen { html { background: #ddd } main { margin: 6mm auto; box-shadow: 0 0 4mm #888 } }
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
        "<table><tr><th>limit state</th><th class=\"n\">" + xml_escape(s.moves) +
        " moves [mm]</th><th class=\"n\">drift [%]</th>" +
        (spread ? "<th class=\"n spread\">" + xml_escape(s.spread_head) + "</th>" : "") +
        "<th>rule</th></tr>";
    const std::size_t shown = std::min(s.limits.size(), kMostSheetLimits);
    for (std::size_t i = 0; i < shown; ++i) body += limit_row(s.limits[i], spread);
    if (shown < s.limits.size())
        body += "<tr><td colspan=\"5\">and " + std::to_string(s.limits.size() - shown) +
                " more, which push writes to limit_states.md</td></tr>";
    body += "</table><p class=\"small\">" + xml_escape(s.drift_words) +
            " &gt;: not reached when the push ended.</p>";
    for (const std::string& text : s.piers)
        body += "<p class=\"small\">" + xml_escape(text) + "</p>";
    return body;
}

/// Number of lines of a text that is wrapped between words.
std::size_t lines_of(const std::string& text, std::size_t characters)
{
    return 1 + (std::max<std::size_t>(text.size(), 1) - 1) / characters;
}

/// Height of the box of the table and the piers below it [mm].
double table_height(const Sheet& s)
{
    constexpr double kLine = 4.4, kFurther = 3.2, kHead = 15.0, kPierLine = 3.4,
                     kMost = 95.0; // [mm]
    const bool spread = !s.spread_head.empty();
    double height = kHead + (spread ? kFurther : 0.0);
    const std::size_t shown = std::min(s.limits.size(), kMostSheetLimits);
    for (std::size_t i = 0; i < shown; ++i)
        height += kLine + kFurther * static_cast<double>(
                                         lines_of(s.limits[i].rule, spread ? 54 : 84) - 1);
    if (s.limits.size() > shown) height += kLine;
    for (const std::string& text : s.piers)
        height += 0.8 + kPierLine * static_cast<double>(lines_of(text, 135));
    return std::min(kMost, height);
}

/// A list with its heading, as wide as `width` [mm].
struct List {
    std::string heading;
    std::vector<std::string> items; ///< plain texts, for their length
    std::string last;               ///< below the items
    double width = 0.0;

    /// Height of the first items [mm].
    [[nodiscard]] double height(std::size_t shown) const
    {
        constexpr double kHeading = 6.0, kLine = 3.3, kGap = 0.9, kCharacter = 1.3; // [mm]
        const auto in_line = static_cast<std::size_t>((width - 4.0) / kCharacter);
        double sum = kHeading;
        for (std::size_t i = 0; i < std::min(shown, items.size()); ++i)
            sum += kGap + kLine * static_cast<double>(lines_of(items[i], in_line));
        return sum + (last.empty() ? 0.0 : kLine);
    }
    /// Number of items that have room, at least one.
    [[nodiscard]] std::size_t fitting(double room) const
    {
        std::size_t n = items.size();
        while (n > 1 && height(n) > room) --n;
        return n;
    }
};

List assumed_list(const Sheet& s, double width)
{
    List list{"What was assumed, and how much it matters",
              {},
              "drystone choices shows what each of them does to this wall.",
              width};
    for (const Assumption& a : s.assumed)
        list.items.push_back(a.what + ": " + a.meaning + ". " + a.how_much + ".");
    return list;
}

std::string assumed_text(const Sheet& s, const List& list, double room)
{
    std::string body = heading(list.heading) + "<ul>";
    for (std::size_t i = 0; i < std::min(s.assumed.size(), list.fitting(room)); ++i) {
        const Assumption& a = s.assumed[i];
        body += "<li><code>" + xml_escape(a.what) + "</code>: " + xml_escape(a.meaning) +
                (a.how_much.empty() ? "" : ". <i>" + xml_escape(a.how_much) + "</i>") +
                ".</li>";
    }
    return body + "</ul><p>" + list.last + "</p>";
}

std::string certainty_text(const Sheet& s, const List& list)
{
    std::string body = heading(list.heading) + "<ul>";
    for (const std::string& text : s.certainty) body += "<li>" + xml_escape(text) + "</li>";
    return body + "</ul>";
}

// Least heights of the picture of the mechanism and of the lists [mm].
constexpr double kLeastPicture = 46.0, kLeastLists = 34.0;

/// Heights of the lower half of the page, and how its lists share the width [mm].
struct Lower {
    double picture = 0.0, table = 0.0, lists = 0.0;
    List assumed, certainty;
};

/// The picture takes what table and lists leave. Where that is little the lists give way.
Lower lower_half(const Sheet& s, double width, double height)
{
    constexpr double kGap = 5.0, kSeen = 58.0, kMost = 88.0;
    Lower lower;
    lower.table = table_height(s);
    double lists = 0.0;
    for (std::size_t shown = std::max<std::size_t>(s.assumed.size(), 2); shown >= 2; --shown) {
        lists = 1e9;
        for (const double share : {0.6, 0.5, 0.4}) {
            const double left = share * (width - kGap);
            const List a = assumed_list(s, left),
                       c{"How sure is this?", s.certainty, "", width - kGap - left};
            const double tall = std::max(a.height(shown), c.height(c.items.size()));
            if (tall >= lists) continue;
            lists = tall;
            lower.assumed = a;
            lower.certainty = c;
        }
        if (height - lower.table - lists >= kSeen) break;
    }
    lower.picture =
        std::clamp(height - lower.table - std::max(kLeastLists, lists), kLeastPicture, kMost);
    lower.lists = height - lower.table - lower.picture;
    return lower;
}

} // namespace

std::string sheet_page(const Sheet& s)
{
    constexpr double kLeft = 12.0, kWide = 186.0; // [mm]
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" +
        std::string(kSheetMark) + "\n<title>" + xml_escape(s.title) + "</title>\n<style>" +
        std::string(kStyle) + "</style>\n</head>\n<body>\n<main>\n";
    page += box(kLeft, 9.0, kWide, 31.0, head(s));
    constexpr double kCurve = 118.0, kTop = 47.0, kHeading = 6.0, kGap = 1.0, kEnd = 286.0;
    const double room =
        kEnd - kTop - kGap - table_height(s) - kLeastPicture - kLeastLists; // [mm]
    const double tall =
        std::clamp(kCurve * attribute(s.curve, "height") / attribute(s.curve, "width"), 52.0,
                   std::clamp(room, 52.0, 70.0));
    page += box(kLeft, kTop - kHeading, 66.0, kHeading + tall,
                heading("The wall") + fitted_picture(s.drawing, 66.0, tall));
    page += box(80.0, kTop - kHeading, kCurve, kHeading + tall,
                heading("Force over movement of the " + s.moves + ", with all limits") +
                    fitted_picture(s.curve, kCurve, tall));
    const double middle = kTop + tall + kGap;
    const Lower lower = lower_half(s, kWide, kEnd - middle);
    const double table = middle + lower.picture, lists = table + lower.table;
    page += box(kLeft, middle, kWide, lower.picture,
                heading("How it moves and fails") +
                    fitted_picture(s.mechanism, kWide, lower.picture - 7.0));
    page += box(kLeft, table, kWide, lower.table, limits_table(s));
    page +=
        box(kLeft, lists, lower.assumed.width, lower.lists,
            "<div class=\"small\">" + assumed_text(s, lower.assumed, lower.lists) + "</div>");
    page +=
        box(kLeft + kWide - lower.certainty.width, lists, lower.certainty.width, lower.lists,
            "<div class=\"small\">" + certainty_text(s, lower.certainty) + "</div>");
    page +=
        box(kLeft, 288.0, kWide, 7.0, "<p class=\"small\">" + xml_escape(s.footer) + "</p>");
    return page + "</main>\n</body>\n</html>\n";
}

} // namespace app
