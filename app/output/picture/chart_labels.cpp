#include "app/output/picture/chart_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

namespace app {
namespace {

constexpr double kSize = 12.0, kAscent = 11.0, kDescent = 4.0; // of a text [px]

/// The cells of the frame, of some pixels each, through which something is drawn.
class Drawn {
  public:
    Drawn(const Chart& chart, const ChartFrame& f)
        : f_(f), columns_(count(f.right - f.left)), rows_(count(f.bottom - f.top)),
          cells_(columns_ * rows_, 0)
    {
        for (const Series& s : chart.series) add(s);
        for (const ChartMark& m : chart.marks)
            if (f.shows(m.x, m.y)) add(f.place(m.x, m.y));
    }

    /// Cells of a box through which a line runs.
    [[nodiscard]] int inside(Pixel low, Pixel high) const
    {
        int n = 0;
        const std::size_t last = std::min(row(high.y) + 1, rows_);
        for (std::size_t j = row(low.y); j < last; ++j)
            for (std::size_t i = column(low.x); i < std::min(column(high.x) + 1, columns_); ++i)
                n += cells_[j * columns_ + i];
        return n;
    }

  private:
    static constexpr double kCell = 3.0; // [px]

    static std::size_t count(double length)
    {
        return static_cast<std::size_t>(std::max(length, 0.0) / kCell) + 1;
    }
    [[nodiscard]] std::size_t column(double x) const { return count(x - f_.left) - 1; }
    [[nodiscard]] std::size_t row(double y) const { return count(y - f_.top) - 1; }

    void add(Pixel p)
    {
        if (p.x < f_.left || p.x > f_.right || p.y < f_.top || p.y > f_.bottom) return;
        cells_[row(p.y) * columns_ + column(p.x)] = 1;
    }
    void add(const Series& s)
    {
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            if (!f_.shows(s.x[i], s.y[i])) continue;
            const Pixel q = f_.place(s.x[i], s.y[i]);
            add(q);
            if (i == 0 || s.line == LineStyle::none || !f_.shows(s.x[i - 1], s.y[i - 1]))
                continue;
            const Pixel p = f_.place(s.x[i - 1], s.y[i - 1]);
            const double steps = std::ceil(std::hypot(q.x - p.x, q.y - p.y) / kCell);
            for (double k = 1.0; k < steps; ++k)
                add({p.x + k / steps * (q.x - p.x), p.y + k / steps * (q.y - p.y)});
        }
    }

    const ChartFrame& f_;
    std::size_t columns_, rows_;
    std::vector<char> cells_;
};

bool overlap(const ChartLabel& a, const ChartLabel& b)
{
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

ChartLabel text_at(double left, double base, const std::string& text)
{
    return {{left, base - kAscent},
            {left + text_width(text, kSize), base + kDescent},
            text,
            false,
            {}};
}

/// Labels of vertical lines beside them, or their numbers above them.
void add_vertical(const Chart& chart, const ChartFrame& f, std::vector<ChartLabel>& all)
{
    for (std::size_t i = 0; i < chart.vertical.size(); ++i) {
        const ReferenceLine& line = chart.vertical[i];
        if (line.label.empty() || !f.shows(line.at, f.y.low)) continue;
        const VerticalLabel& v = f.vertical[i];
        if (v.number > 0)
            all.push_back({{v.at - kBadge, f.top + 2.0},
                           {v.at + kBadge, f.top + 2.0 + 2.0 * kBadge},
                           std::to_string(v.number),
                           true,
                           {}});
        else
            all.push_back(text_at(v.at, f.top + 13.0, line.label));
    }
}

/// A label where it may stand, and how well it stands there.
struct Candidate {
    ChartLabel label;
    double cost = std::numeric_limits<double>::infinity();
};

/// How bad a place is: worst over another label, bad over lines of data, better near by.
double cost_of(const ChartLabel& label, double distance, const ChartFrame& f,
               const Drawn& drawn, const std::vector<ChartLabel>& others)
{
    constexpr double kOutside = 1e6, kCovers = 1e4, kOnLine = 100.0, kReference = 12.0;
    double cost = distance;
    if (label.low.x < f.left + 2.0 || label.high.x > f.right - 2.0 ||
        label.low.y < f.top + 2.0 || label.high.y > f.bottom - 2.0)
        cost += kOutside;
    for (const ChartLabel& o : others) cost += overlap(label, o) ? kCovers : 0.0;
    for (const double x : f.lines)
        cost += label.low.x < x && x < label.high.x ? kReference : 0.0;
    return cost + kOnLine * drawn.inside(label.low, label.high);
}

void take_better(Candidate& best, ChartLabel label, double cost)
{
    if (cost < best.cost) best = {std::move(label), cost};
}

/// At the end and the side of a horizontal line where the fewest lines run through the text.
void add_horizontal(const Chart& chart, const ChartFrame& f, const Drawn& drawn,
                    std::vector<ChartLabel>& all)
{
    for (const ReferenceLine& line : chart.horizontal) {
        if (line.label.empty() || !f.shows(f.x.low, line.at)) continue;
        const double y = f.place(f.x.low, line.at).y,
                     end = f.right - 5.0 - text_width(line.label, kSize);
        Candidate best;
        for (const double left : {end, f.left + 5.0})
            for (const double base : {y - 5.0, y + 14.0}) {
                ChartLabel label = text_at(left, base, line.label);
                const double cost = cost_of(label, 0.0, f, drawn, all);
                take_better(best, std::move(label), cost);
            }
        all.push_back(std::move(best.label));
    }
}

/// Distance of a point from a box [px].
double distance(Pixel p, const ChartLabel& label)
{
    const double x = std::max({label.low.x - p.x, p.x - label.high.x, 0.0}),
                 y = std::max({label.low.y - p.y, p.y - label.high.y, 0.0});
    return std::hypot(x, y);
}

/// Right above the point, or wherever in the frame the text covers least.
void add_marks(const Chart& chart, const ChartFrame& f, const Drawn& drawn,
               std::vector<ChartLabel>& all)
{
    constexpr double kStep = 6.0, kNear = 16.0; // [px]
    for (const ChartMark& mark : chart.marks) {
        if (mark.label.empty() || !f.shows(mark.x, mark.y)) continue;
        const Pixel at = f.place(mark.x, mark.y);
        const double width = text_width(mark.label, kSize);
        Candidate best;
        const auto try_at = [&](double left, double base) {
            ChartLabel label = text_at(left, base, mark.label);
            const double cost = cost_of(label, distance(at, label), f, drawn, all);
            take_better(best, std::move(label), cost);
        };
        for (const double left : {at.x + 8.0, at.x - 8.0 - width})
            for (const double base : {at.y - 8.0, at.y + 18.0}) try_at(left, base);
        constexpr double kGood = 30.0;
        if (best.cost > kGood)
            for (double base = f.top + 14.0; base < f.bottom; base += kStep)
                for (double left = f.left + 3.0; left + width < f.right; left += kStep)
                    try_at(left, base);
        if (distance(at, best.label) > kNear) best.label.point = at;
        all.push_back(std::move(best.label));
    }
}

std::string draw_leader(const ChartLabel& label)
{
    const Pixel p = *label.point;
    const Pixel end = {std::clamp(p.x, label.low.x, label.high.x),
                       std::clamp(p.y, label.low.y, label.high.y)};
    return svg_line(end, p, svg_stroke("#222", 0.8));
}

} // namespace

std::vector<ChartLabel> chart_labels(const Chart& chart, const ChartFrame& frame)
{
    std::vector<ChartLabel> all;
    add_vertical(chart, frame, all);
    const Drawn drawn(chart, frame);
    add_horizontal(chart, frame, drawn, all);
    add_marks(chart, frame, drawn, all);
    return all;
}

std::string draw_labels(const std::vector<ChartLabel>& labels)
{
    // Texts have a white rim, to be read over lines.
    const std::string size = "font-size=\"12\" ",
                      rim = size + "stroke=\"white\" stroke-width=\"4\" "
                                   "stroke-linejoin=\"round\" fill=\"white\"";
    std::string drawn;
    for (const ChartLabel& l : labels) {
        if (l.point) drawn += draw_leader(l);
        if (l.numbered) {
            drawn += draw_number({(l.low.x + l.high.x) / 2, (l.low.y + l.high.y) / 2}, l.text);
            continue;
        }
        const Pixel at{l.low.x, l.high.y - kDescent};
        drawn += svg_text(at, l.text, rim) + svg_text(at, l.text, size);
    }
    return drawn;
}

} // namespace app
