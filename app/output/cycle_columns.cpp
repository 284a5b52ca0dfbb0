#include "app/output/cycle_columns.hpp"

#include <cstddef>
#include <functional>
#include <utility>

namespace app {
namespace {

using fragility::Cycle;

constexpr double kMm = 1e3, kKn = 1e-3, kKnPerMm = 1e-6, kPercent = 100.0;

/// A combination of both residuals; nothing where one is missing.
std::optional<double> combined(const Cycle& c, double minus_share)
{
    if (!c.residual_plus || !c.residual_minus) return std::nullopt;
    return 0.5 * (*c.residual_plus + minus_share * *c.residual_minus);
}

/// A number of the ledger where the path passes zero displacement behind a point. The ledger of
/// a point stands at the end of its interval, the point itself in the middle.
template <class Read>
double at_zero(std::span<const dem::CurvePoint> curve, std::size_t point, double share,
               Read read)
{
    if (share == 0.0) return read(curve[point].energy);
    const double side = curve[point].displacement;
    std::size_t after = point + 1;
    while (after > 1 && curve[after - 1].interval_end * side <= 0.0) --after;
    const dem::CurvePoint &a = curve[after - 1], &b = curve[after];
    const double to_zero = a.interval_end / (a.interval_end - b.interval_end);
    return read(a.energy) + to_zero * (read(b.energy) - read(a.energy));
}

/// Stiffness of the first cycle that has one; nothing where none has.
std::optional<double> first_stiffness(const std::vector<Cycle>& cycles)
{
    for (const Cycle& c : cycles)
        if (const auto stiffness = fragility::secant_stiffness(c)) return stiffness;
    return std::nullopt;
}

} // namespace

std::vector<CycleColumn> cycle_columns(const std::vector<Cycle>& cycles,
                                       std::span<const dem::CurvePoint> curve)
{
    const std::optional<double> first = first_stiffness(cycles);
    std::vector<CycleColumn> columns;
    const auto add = [&](std::string_view name, std::string_view unit, double scale,
                         const auto& read) {
        CycleColumn column{name, unit, scale, {}};
        for (const Cycle& c : cycles) column.values.push_back(read(c));
        columns.push_back(std::move(column));
    };
    const auto add_part = [&](std::string_view name, const auto& read) {
        add(name, "J", 1.0, [&](const Cycle& c) -> std::optional<double> {
            return at_zero(curve, c.end, c.end_share, read) -
                   at_zero(curve, c.begin, c.begin_share, read);
        });
    };
    double number = 0.0;
    add("cycle", "", 1.0, [&](const Cycle&) { return ++number; });
    add("amplitude", "mm", kMm, [](const Cycle& c) { return fragility::amplitude(c); });
    add("force_plus", "kN", kKn, std::mem_fn(&Cycle::force_plus));
    add("force_minus", "kN", kKn, std::mem_fn(&Cycle::force_minus));
    add("energy", "J", 1.0, std::mem_fn(&Cycle::energy));
    add("damping", "percent", kPercent,
        [](const Cycle& c) { return fragility::equivalent_damping(c); });
    add("residual_plus", "mm", kMm, std::mem_fn(&Cycle::residual_plus));
    add("residual_minus", "mm", kMm, std::mem_fn(&Cycle::residual_minus));
    add("stiffness", "kN_per_mm", kKnPerMm,
        [](const Cycle& c) { return fragility::secant_stiffness(c); });
    add("stiffness_share", "", 1.0, [&](const Cycle& c) -> std::optional<double> {
        const std::optional<double> stiffness = fragility::secant_stiffness(c);
        if (!stiffness || !(*first > 0.0)) return std::nullopt;
        return *stiffness / *first;
    });
    add("half_width", "mm", kMm, [](const Cycle& c) { return combined(c, -1.0); });
    add("shift", "mm", kMm, [](const Cycle& c) { return combined(c, 1.0); });
    add("displacement_plus", "mm", kMm, std::mem_fn(&Cycle::displacement_plus));
    add("displacement_minus", "mm", kMm, std::mem_fn(&Cycle::displacement_minus));
    add("closed", "", 1.0, [](const Cycle& c) { return c.closed ? 1.0 : 0.0; });
    add_part("friction", [](const dem::Energy& e) { return e.friction; });
    add_part("fracture", [](const dem::Energy& e) { return e.fracture; });
    add_part("crushing", [](const dem::Energy& e) { return e.crushing; });
    add_part("solver", [](const dem::Energy& e) { return e.damping; });
    add_part("stored", [](const dem::Energy& e) { return e.stored(); });
    add_part("closing", [](const dem::Energy& e) { return e.closing; });
    return columns;
}

} // namespace app
