#include "app/record/record_pictures.hpp"

#include "app/output/picture/chart_svg.hpp"
#include "app/record/record_table.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t kShownSpectra = 12; ///< with names and colours; the others are grey

/// The extremes of each of some thousand parts, so that a million samples make a small picture.
Series thinned(const ground::GroundMotion& m)
{
    constexpr std::size_t kParts = 2000;
    const std::vector<double>& a = m.acceleration;
    const std::size_t part = std::max<std::size_t>(1, a.size() / kParts);
    Series s;
    const auto add = [&](std::size_t i) {
        s.x.push_back(m.step * static_cast<double>(i));
        s.y.push_back(a[i] / ground::kGravity);
    };
    for (std::size_t i = 0; i < a.size(); i += part) {
        const auto first = a.begin() + static_cast<std::ptrdiff_t>(i);
        const auto last = a.begin() + static_cast<std::ptrdiff_t>(std::min(a.size(), i + part));
        const auto [low, high] = std::minmax_element(first, last);
        const auto l = static_cast<std::size_t>(low - a.begin());
        const auto h = static_cast<std::size_t>(high - a.begin());
        add(std::min(l, h));
        if (l != h) add(std::max(l, h));
    }
    return s;
}

} // namespace

std::string motion_svg(const ground::Record& record)
{
    const ground::GroundMotion& m = record.motion;
    Chart c;
    c.title = m.name;
    c.x_label = "time [s]";
    c.y_label = "acceleration of the ground [g]";
    c.height = 300.0;
    Series line = thinned(m);
    line.colour = palette(0);
    line.width = 1.0;
    c.series.push_back(line);
    std::size_t peak = 0;
    for (std::size_t i = 0; i < m.acceleration.size(); ++i)
        if (std::abs(m.acceleration[i]) > std::abs(m.acceleration[peak])) peak = i;
    const double a = m.acceleration[peak] / ground::kGravity;
    c.marks.push_back(
        {m.step * static_cast<double>(peak), a, "PGA " + number(std::abs(a), 3) + " g"});
    return line_chart(c);
}

std::string spectrum_svg(const std::vector<ground::Record>& records,
                         const std::vector<std::vector<double>>& spectra)
{
    Chart c;
    c.title = "Pseudo-acceleration at 5 % of damping";
    c.x_label = "period [s]";
    c.y_label = "pseudo-acceleration [g]";
    c.log_x = true;
    const std::vector<double> periods = spectrum_periods();
    for (std::size_t i = 0; i < records.size(); ++i) {
        const bool named = records.size() <= kShownSpectra;
        Series s{named ? records[i].motion.name : "", periods, spectra[i]};
        s.colour = named ? palette(i) : "#999999";
        s.width = named ? 1.6 : 0.8;
        c.series.push_back(s);
    }
    if (records.size() > 1) {
        Series mean{"geometric mean", periods, {}};
        mean.colour = "#000000";
        mean.width = 2.6;
        for (std::size_t k = 0; k < periods.size(); ++k) {
            double sum = 0.0;
            for (const auto& s : spectra) sum += std::log(std::max(s[k], 1e-12));
            mean.y.push_back(std::exp(sum / static_cast<double>(spectra.size())));
        }
        c.series.push_back(mean);
    }
    return line_chart(c);
}

} // namespace app
