#include "app/output/cycles_csv.hpp"

#include "app/text/number_text.hpp"

#include <cstddef>
#include <optional>

namespace app {
namespace {

constexpr int kDigits = 9; // as in capacity.csv
constexpr double kMm = 1e3, kKn = 1e-3, kKnPerMm = 1e-6;

std::string cell(std::optional<double> value, double scale)
{
    return ',' + (value ? number(*value * scale, kDigits) : std::string());
}

/// A combination of both residuals; nothing where one is missing.
std::optional<double> combined(const fragility::Cycle& c, double minus_share)
{
    if (!c.residual_plus || !c.residual_minus) return std::nullopt;
    return 0.5 * (*c.residual_plus + minus_share * *c.residual_minus);
}

/// A number of the ledger where the path passes zero displacement behind a point.
template <class Read>
double at_zero(std::span<const dem::Energy> ledger, std::size_t point, double share, Read read)
{
    const double x = read(ledger[point]);
    return share == 0.0 ? x : x + share * (read(ledger[point + 1]) - x);
}

} // namespace

std::string cycles_csv(const std::vector<fragility::Cycle>& cycles,
                       std::span<const dem::Energy> ledger)
{
    const bool loses = !ledger.empty() && ledger.back().closing > 0.0;
    std::string table =
        "cycle,amplitude_mm,force_plus_kN,force_minus_kN,energy_J,damping_percent,residual_"
        "plus_mm,"
        "residual_minus_mm,stiffness_kN_per_mm,stiffness_share,half_width_mm,shift_mm,"
        "displacement_plus_mm,displacement_minus_mm,closed,friction_J,fracture_J,crushing_J,"
        "solver_J,stored_J";
    table += loses ? ",closing_J\n" : "\n";
    std::optional<double> first;
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        const fragility::Cycle& c = cycles[i];
        const std::optional<double> stiffness = fragility::secant_stiffness(c);
        if (!first) first = stiffness;
        std::optional<double> share;
        if (stiffness && *first > 0.0) share = *stiffness / *first;
        table += std::to_string(i + 1) + cell(fragility::amplitude(c), kMm) +
                 cell(c.force_plus, kKn) + cell(c.force_minus, kKn) + cell(c.energy, 1.0) +
                 cell(fragility::equivalent_damping(c), 100.0) + cell(c.residual_plus, kMm) +
                 cell(c.residual_minus, kMm) + cell(stiffness, kKnPerMm) + cell(share, 1.0) +
                 cell(combined(c, -1.0), kMm) + cell(combined(c, 1.0), kMm) +
                 cell(c.displacement_plus, kMm) + cell(c.displacement_minus, kMm) +
                 (c.closed ? ",1" : ",0");
        const auto part = [&](const auto& read) {
            return cell(at_zero(ledger, c.end, c.end_share, read) -
                            at_zero(ledger, c.begin, c.begin_share, read),
                        1.0);
        };
        table += part([](const dem::Energy& e) { return e.friction; }) +
                 part([](const dem::Energy& e) { return e.fracture; }) +
                 part([](const dem::Energy& e) { return e.crushing; }) +
                 part([](const dem::Energy& e) { return e.damping; }) +
                 part([](const dem::Energy& e) { return e.stored(); });
        if (loses) table += part([](const dem::Energy& e) { return e.closing; });
        table += '\n';
    }
    return table;
}

} // namespace app
