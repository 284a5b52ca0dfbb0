#include "bench/tested/comparison.hpp"

#include "app/text/number_text.hpp"

namespace bench {
namespace {

using fragility::LimitDisplacement;
using fragility::Reading;

std::string cell(const std::optional<double>& value, int decimals)
{
    return value ? app::fixed(*value, decimals) : "-";
}

std::string ultimate_cell(const LimitDisplacement& x)
{
    if (x.reading == Reading::not_defined) return "-";
    return (x.reading == Reading::censored ? "> " : "") + app::fixed(x.displacement, 2);
}

std::optional<double> ratio(double value, const std::optional<double>& reference)
{
    if (!reference) return std::nullopt;
    return value / *reference;
}

/// "41.5 (SW.100.1), 48.2 (SW.100.2)"
template <class Text> std::string listed(const std::vector<CurveFacts>& tests, Text text)
{
    std::string out;
    for (const CurveFacts& t : tests)
        out += (out.empty() ? "" : ", ") + text(t) + " (" + t.name + ")";
    return out.empty() ? "-" : out;
}

std::string peak_row(const LevelComparison& l)
{
    const std::optional<PaperMeans> paper = paper_means(l.stress_MPa);
    std::optional<double> rocking, mixed, pooled;
    if (paper) {
        rocking = paper->rocking_peak_kN;
        mixed = paper->mixed_peak_kN;
        pooled = pooled_peak_kN(*paper);
    }
    const std::optional<double> mean = mean_peak_kN(l);
    return "| " + app::fixed(l.stress_MPa, 2) + " | " +
           listed(l.tests, [](const CurveFacts& t) { return app::fixed(t.peak_kN, 1); }) +
           " | " + cell(mean, 1) + " | " + cell(rocking, 1) + " | " + cell(mixed, 1) + " | " +
           cell(pooled, 1) + " | " + app::fixed(l.ours.peak_kN, 1) + " | " +
           cell(ratio(l.ours.peak_kN, mean), 2) + " | " +
           cell(ratio(l.ours.peak_kN, pooled), 2) + " |\n";
}

std::string ultimate_row(const LevelComparison& l)
{
    const std::optional<PaperMeans> paper = paper_means(l.stress_MPa);
    return "| " + app::fixed(l.stress_MPa, 2) + " | " +
           listed(l.tests, [](const CurveFacts& t) { return ultimate_cell(t.ultimate_mm); }) +
           " | " + cell(paper ? paper->mixed_ultimate_mm : std::nullopt, 1) + " | " +
           ultimate_cell(l.ours.ultimate_mm) + " |\n";
}

/// One row of the long table.
struct Source {
    std::string name;
    double peak_kN;
    LimitDisplacement ultimate_mm;
};

std::vector<Source> sources(const LevelComparison& l)
{
    std::vector<Source> out = {{"drystone", l.ours.peak_kN, l.ours.ultimate_mm}};
    for (const CurveFacts& t : l.tests) out.push_back({t.name, t.peak_kN, t.ultimate_mm});
    if (const auto mean = mean_peak_kN(l)) out.push_back({"mean of tests", *mean, {}});
    const std::optional<PaperMeans> paper = paper_means(l.stress_MPa);
    if (!paper) return out;
    out.push_back({"paper rocking mean", paper->rocking_peak_kN, {}});
    if (paper->mixed_peak_kN) {
        LimitDisplacement ultimate;
        if (paper->mixed_ultimate_mm)
            ultimate = {*paper->mixed_ultimate_mm, Reading::observed, {}};
        out.push_back({"paper mixed mean", *paper->mixed_peak_kN, ultimate});
    }
    out.push_back({"paper mean of all walls", pooled_peak_kN(*paper), {}});
    return out;
}

} // namespace

std::optional<PaperMeans> paper_means(double stress_MPa)
{
    if (stress_MPa == 0.15) return PaperMeans{1.00, 16.24, {}, {}};
    if (stress_MPa == 0.50) return PaperMeans{0.28, 47.71, 45.90, 18.34};
    if (stress_MPa == 0.75) return PaperMeans{0.34, 69.51, 63.89, 19.47};
    if (stress_MPa == 1.00) return PaperMeans{0.28, 91.58, 80.97, 17.93};
    if (stress_MPa == 1.25) return PaperMeans{0.08, 112.13, 100.72, 16.26};
    return std::nullopt;
}

double pooled_peak_kN(const PaperMeans& p)
{
    if (!p.mixed_peak_kN) return p.rocking_peak_kN;
    return p.rocking_share * p.rocking_peak_kN + (1.0 - p.rocking_share) * *p.mixed_peak_kN;
}

CurveFacts facts(const std::string& name, const CurveTable& table)
{
    return {name, fragility::peak(table.curve()).force,
            fragility::drop_after_peak(table.curve())};
}

std::optional<double> mean_peak_kN(const LevelComparison& level)
{
    if (level.tests.empty()) return std::nullopt;
    double sum = 0.0;
    for (const CurveFacts& t : level.tests) sum += t.peak_kN;
    return sum / static_cast<double>(level.tests.size());
}

std::string comparison_markdown(std::span<const LevelComparison> levels)
{
    std::string text =
        "Peak force [kN]. Tests: Lourenço et al. (2005). Paper: means of its random walls by "
        "mode "
        "(Tables 6 and 7), and of all walls by the shares of the modes (section 4.2); its "
        "deterministic curves (Fig. 6) are drawn without numbers.\n\n"
        "| stress [MPa] | tests | mean of tests | paper, rocking | paper, mixed | paper, all "
        "walls | Drystone | Drystone / tests | Drystone / paper |\n"
        "|---|---|---|---|---|---|---|---|---|\n";
    for (const LevelComparison& l : levels) text += peak_row(l);
    text +=
        "\nUltimate displacement [mm]: first drop to 80 % of the peak; \"> 29.85\": not "
        "reached "
        "by 29.85 mm, where the curve ends. Paper: mean of its mixed-mode walls (Table 7).\n\n"
        "| stress [MPa] | tests | paper, mixed | Drystone |\n"
        "|---|---|---|---|\n";
    for (const LevelComparison& l : levels) text += ultimate_row(l);
    return text;
}

std::string comparison_csv(std::span<const LevelComparison> levels)
{
    std::string text = "stress_MPa,source,peak_force_kN,drystone_over_source,ultimate_"
                       "displacement_mm,censored\n";
    for (const LevelComparison& l : levels)
        for (const Source& s : sources(l)) {
            const bool defined = s.ultimate_mm.reading != Reading::not_defined;
            text += app::fixed(l.stress_MPa, 2) + "," + s.name + "," +
                    app::number(s.peak_kN, 6) + "," +
                    app::number(l.ours.peak_kN / s.peak_kN, 6) + "," +
                    (defined ? app::number(s.ultimate_mm.displacement, 6) : "") + "," +
                    (defined ? (s.ultimate_mm.reading == Reading::censored ? "1" : "0") : "") +
                    "\n";
        }
    return text;
}

} // namespace bench
