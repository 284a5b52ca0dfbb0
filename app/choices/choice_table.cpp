#include "app/choices/choice_table.hpp"

#include "app/output/picture/svg_elements.hpp"
#include "app/study/answers/number_cells.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// Relative change [-]; NaN where one of the two is not defined.
double relative(double value, double base)
{
    return base > 0.0 && std::isfinite(value) ? value / base - 1.0 : kUnknown;
}

double limit_of(const WallReading& r) { return displacement_of(r.ultimate); }

Number change_cell(double change, Sense sense)
{
    Number n = plain_number(100.0 * change, 0);
    n.sense = sense;
    return std::isfinite(change) ? n : Number{};
}

/// A limit that was not reached lies above; beside a base that was not reached it says nothing.
bool comparable(const WallReading& r, const WallReading& base)
{
    return !is_censored(base.ultimate) && std::isfinite(limit_of(r)) &&
           std::isfinite(limit_of(base));
}

/// A cell of a choice that could be applied.
template <class Value> TableColumn<ChoiceResult> applied(const Head& head, Value value)
{
    return {head, [value](const ChoiceResult& c) -> Cell {
                return c.reading ? Cell(value(*c.reading)) : Cell();
            }};
}

TableColumn<ChoiceResult> number_of(const WallNumber& n, unsigned holds = 0)
{
    return {number_head(n, holds), [&n, holds](const ChoiceResult& c) -> Cell {
                return c.reading ? Cell(number_cell(n, *c.reading, c.height, holds)) : Cell();
            }};
}

Number limit_change(const WallReading& r, const WallReading& base)
{
    const Sense sense = is_censored(r.ultimate) ? Sense::above : Sense::equal;
    return comparable(r, base) ? change_cell(relative(limit_of(r), limit_of(base)), sense)
                               : Number{};
}

void sort_bars(std::vector<Tornado::Bar>& bars)
{
    std::ranges::stable_sort(bars, [](const Tornado::Bar& a, const Tornado::Bar& b) {
        return std::abs(a.change) > std::abs(b.change);
    });
}

constexpr double kRow = 22.0, kLabel = 250.0, kHalf = 110.0, kTop = 74.0; // [px]

std::string percent_label(const Tornado::Bar& bar)
{
    const std::string percent = fixed(100.0 * bar.change, 0);
    const bool sign = percent != "0" && percent.front() != '-';
    return std::string(bar.at_least ? "> " : "") + (sign ? "+" : "") + percent + " %";
}

/// Bars of one quantity; a change beyond twice is cut off there, its number is not.
std::string bars_svg(const std::vector<Tornado::Bar>& bars, double left,
                     const std::string& head)
{
    constexpr double kLeast = 0.05, kMost = 2.0;
    double largest = kLeast;
    for (const Tornado::Bar& b : bars)
        largest = std::max(largest, std::min(kMost, std::abs(b.change)));
    const double middle = left + kLabel + kHalf;
    std::string body = svg_text({left, kTop - 18.0}, head, "font-weight=\"bold\"");
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const Tornado::Bar& b = bars[i];
        const double y = kTop + kRow * static_cast<double>(i);
        const double length = kHalf * std::min(1.0, std::abs(b.change) / largest) * 0.6;
        const bool up = b.change >= 0.0;
        body +=
            svg_text({left + kLabel - 6.0, y + 12.0}, b.label,
                     "text-anchor=\"end\" font-size=\"11\"") +
            svg_rectangle({up ? middle : middle - length, y + 1.0}, length, kRow - 7.0,
                          svg_attribute("fill", up ? "#0072B2" : "#D55E00")) +
            svg_text({middle + (up ? length + 5.0 : -length - 5.0), y + 12.0}, percent_label(b),
                     svg_attribute("text-anchor", up ? "start" : "end") + "font-size=\"11\"");
    }
    return body + svg_line({middle, kTop - 6.0},
                           {middle, kTop + kRow * static_cast<double>(bars.size())},
                           svg_stroke("#444", 1.2));
}

} // namespace

Table choice_results(const ChoiceResult& base, const std::vector<ChoiceResult>& all)
{
    Table t;
    t.title = "One choice at a time";
    t.caption = "The wall of mean values as the study has it, and with one choice changed. "
                "Ultimate: where the force "
                "is down to the share of the peak that fragility.ultimate_share says; '>' "
                "marks walls that had not "
                "come down so far. Changes are those from the first row.";
    t.keys = 2;
    const WallReading& from = *base.reading;
    std::vector<ChoiceResult> rows = {base};
    rows.front().key = "as it is";
    rows.front().before = rows.front().after = {};
    rows.insert(rows.end(), all.begin(), all.end());
    fill(t,
         TableColumns<ChoiceResult>{
             {"choice", &ChoiceResult::key},
             {"changed to", &ChoiceResult::after},
             {{"now", kDetail}, &ChoiceResult::before},
             number_of(wall_number("peak_force")),
             applied("change of peak [%]",
                     [&](const WallReading& r) {
                         return change_cell(relative(peak_force(r), peak_force(from)),
                                            Sense::equal);
                     }),
             number_of(wall_number("ultimate_displacement"), kCensored | kDetail),
             number_of(wall_number("ultimate_drift"), kCensored),
             applied({"change of limit [%]", kCensored},
                     [&](const WallReading& r) { return limit_change(r, from); }),
             applied("mode", [](const WallReading& r) { return std::string(name(r.mode)); }),
             {{"note", kNote},
              [](const ChoiceResult& c) {
                  return c.reading ? std::string() : "not applied: " + c.reason;
              }}},
         rows);
    return t;
}

Tornado tornado(const ChoiceResult& base, const std::vector<ChoiceResult>& all)
{
    Tornado t;
    for (const ChoiceResult& c : all) {
        if (!c.reading) continue;
        const std::string label = c.key + " = " + c.after;
        const double peak = relative(peak_force(*c.reading), peak_force(*base.reading));
        if (std::isfinite(peak)) t.peak.push_back({label, peak, false});
        if (comparable(*c.reading, *base.reading))
            t.limit.push_back({label, relative(limit_of(*c.reading), limit_of(*base.reading)),
                               is_censored(c.reading->ultimate)});
    }
    sort_bars(t.peak);
    sort_bars(t.limit);
    return t;
}

std::string tornado_svg(const Tornado& t, const std::string& title)
{
    constexpr double kPanel = kLabel + 2.0 * kHalf + 20.0, kMargin = 16.0;
    const std::size_t rows = std::max<std::size_t>({t.peak.size(), t.limit.size(), 1});
    std::string body =
        svg_text({kMargin, 30.0}, title, "font-size=\"17\" font-weight=\"bold\"") +
        bars_svg(t.peak, kMargin, "Change of the peak force");
    body += t.limit.empty()
                ? svg_text({kMargin + kPanel, kTop - 18.0},
                           "The wall as it is has no drift limit to compare with", "")
                : bars_svg(t.limit, kMargin + kPanel, "Change of the drift limit");
    return svg_page(2.0 * (kMargin + kPanel), kTop + kRow * static_cast<double>(rows) + 16.0,
                    "What matters for this wall", body);
}

} // namespace app
