#include "fragility/limit_states.hpp"

#include <array>
#include <charconv>
#include <stdexcept>

namespace fragility {
namespace {

/// What the three sets are made of.
struct Parts {
    Peak top;
    LimitDisplacement ultimate, collapse;
    LimitDisplacement yield;
    std::string ultimate_rule;
    std::string bilinear_rule;
};

LimitDisplacement scaled(LimitDisplacement x, double factor)
{
    x.displacement *= factor;
    return x;
}

/// 0.8 -> "80 %", 2/3 -> "66.67 %"
std::string percent(double share)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), 100.0 * share,
                                   std::chars_format::general, 4);
    return std::string(text.data(), end.ptr) + " %";
}

LimitDisplacement yield_of(const Curve& curve, const LimitDisplacement& ultimate,
                           const Peak& top, double share)
{
    if (ultimate.reading == Reading::not_defined) return ultimate;
    const Bilinear b = equal_energy_bilinear(curve, ultimate.displacement, share);
    if (b.outcome != BilinearOutcome::found)
        return {0.0, Reading::not_defined, reason(b.outcome)};
    if (ultimate.reading == Reading::observed)
        return {b.yield_displacement, Reading::observed, {}};
    if (!top.at_end)
        return {b.yield_displacement, Reading::observed, "bilinear up to the end of the curve"};
    if (b.ductility < kShownYield)
        return {b.yield_displacement, Reading::censored,
                "the curve ends before it has yielded"};
    return {b.yield_displacement, Reading::observed,
            "bilinear up to the end of the curve, where it still rises"};
}

Parts read_parts(const Curve& curve, const LimitStateOptions& o)
{
    const Peak top = peak(curve);
    const LimitDisplacement ultimate = drop_after_peak(curve, o.ultimate_share, o.crossing);
    const char* order = o.crossing == Crossing::first ? "first" : "last";
    return {top,
            ultimate,
            drop_after_peak(curve, 0.0),
            yield_of(curve, ultimate, top, o.bilinear_share),
            std::string(order) + " drop to " + percent(o.ultimate_share) + " of the peak",
            "yield of the equal-energy bilinear through " + percent(o.bilinear_share) +
                " of the peak"};
}

/// SLD: whichever comes first.
LimitDisplacement yield_or_peak(const Parts& p)
{
    if (p.yield.reading != Reading::not_defined && p.top.displacement < p.yield.displacement)
        return {p.top.displacement, Reading::observed, "the peak comes before the yield"};
    return p.yield;
}

std::vector<LimitState> ntc(const Parts& p)
{
    const LimitDisplacement sld = yield_or_peak(p);
    return {{"SLO", "2/3 of SLD", scaled(sld, 2.0 / 3.0)},
            {"SLD", p.bilinear_rule + ", or the peak if it comes first", sld},
            {"SLV", "3/4 of SLC", scaled(p.ultimate, 0.75)},
            {"SLC", p.ultimate_rule, p.ultimate}};
}

std::vector<LimitState> ec8(const Parts& p)
{
    return {{"DL", p.bilinear_rule, p.yield},
            {"SD", "3/4 of NC", scaled(p.ultimate, 0.75)},
            {"NC", p.ultimate_rule, p.ultimate}};
}

std::vector<LimitState> paper(const Parts& p)
{
    return {{"ultimate", p.ultimate_rule, p.ultimate}};
}

std::vector<LimitState> collapse(const Parts& p)
{
    return {
        {"collapse", "no force is left after the peak, or the wall comes down", p.collapse}};
}

/// A set of limit states is a row here and a function above.
struct Set {
    std::string_view name;
    std::vector<LimitState> (*read)(const Parts&);
};
constexpr std::array kSets = {Set{"paper", paper}, Set{"ntc", ntc}, Set{"ec8", ec8},
                              Set{"collapse", collapse}};

constexpr auto kNames = [] {
    std::array<std::string_view, kSets.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = kSets[i].name;
    return names;
}();

} // namespace

std::vector<LimitState> read_limit_states(const Curve& curve, std::string_view set,
                                          const LimitStateOptions& options)
{
    const Parts parts = read_parts(curve, options);
    for (const Set& s : kSets)
        if (s.name == set) return s.read(parts);
    throw std::invalid_argument("limit states: no set " + std::string(set));
}

std::span<const std::string_view> limit_state_sets() { return kNames; }

} // namespace fragility
