#include "fragility/limit_states.hpp"

#include "fragility/cyclic_curve.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace fragility {
namespace {

/// Parts that the three sets are made of.
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

/// The share of the peak at which the stiffness is read: not beyond first loading.
double share_of_stiffness(const Curve& curve, const LimitStateOptions& o)
{
    const double top = peak(curve).force;
    if (o.reach <= 0.0 || !(top > 0.0)) return o.bilinear_share;
    double reached = 0.0;
    for (std::size_t i = 0; i < curve.displacement.size(); ++i) {
        if (curve.displacement[i] > o.reach) break;
        reached = std::max(reached, curve.force[i]);
        if (curve.displacement[i] == o.reach) break; // a step there is of the next cycle
    }
    return reached > 0.0 ? std::min(o.bilinear_share, reached / top) : o.bilinear_share;
}

/// Up to a censored ultimate displacement the yield is a bound that holds however the push goes
/// on.
LimitDisplacement yield_of(const Curve& curve, const LimitDisplacement& ultimate,
                           const LimitStateOptions& o)
{
    if (ultimate.reading == Reading::not_defined) return ultimate;
    if (!o.no_yield.empty()) return {0.0, Reading::not_defined, o.no_yield};
    if (o.residual > 0.0) {
        const Backbone own = from_own_zero(curve, o.residual);
        LimitDisplacement end = ultimate;
        end.displacement += o.residual;
        LimitStateOptions rest = o;
        rest.residual = 0.0;
        if (o.reach > 0.0) rest.reach += o.residual;
        return yield_of({own.displacement, own.force}, end, rest);
    }
    const double share = share_of_stiffness(curve, o);
    const Bilinear b = equal_energy_bilinear(curve, ultimate.displacement, share);
    if (b.outcome != BilinearOutcome::found)
        return {0.0, Reading::not_defined, reason(b.outcome)};
    if (ultimate.reading == Reading::observed)
        return {b.yield_displacement, Reading::observed, {}};
    const double least =
        o.ultimate_share * peak(curve).force / secant_stiffness(curve, share).value();
    return {std::min(b.yield_displacement, least), Reading::censored,
            "this value still depends on where the push ended; push further"};
}

Parts read_parts(const Curve& curve, const LimitStateOptions& o)
{
    const Peak top = peak(curve);
    const LimitDisplacement ultimate = drop_after_peak(curve, o.ultimate_share, o.crossing);
    const char* order = o.crossing == Crossing::first ? "first" : "last";
    return {top,
            ultimate,
            drop_after_peak(curve, 0.0),
            yield_of(curve, ultimate, o),
            std::string(order) + " drop to " + percent(o.ultimate_share) + " of the peak",
            "yield of the equal-energy bilinear through " + percent(o.bilinear_share) +
                " of the peak"};
}

/// The part of a curve up to a displacement.
class CutCurve {
  public:
    CutCurve(const Curve& curve, double at)
    {
        double d0 = 0.0, f0 = 0.0; // led there from the origin
        if (curve.displacement.front() == 0.0) f0 = curve.force.front();
        for (std::size_t i = 0; i < curve.displacement.size(); ++i) {
            const double d = curve.displacement[i], f = curve.force[i];
            if (d > at) {
                if (d0 < at) add(at, f0 + (f - f0) * (at - d0) / (d - d0));
                return;
            }
            add(d0 = d, f0 = f);
        }
    }
    operator Curve() const { return {displacement_, force_}; } // NOLINT: reads as a curve

  private:
    void add(double d, double f)
    {
        displacement_.push_back(d);
        force_.push_back(f);
    }
    std::vector<double> displacement_, force_;
};

/// A drift limit of a code.
struct CodeLimit {
    double at; ///< [length]; 0: none
    std::string rule;
    std::string_view governs; ///< the reason where it comes before the fall of the force
};

CodeLimit code_limit(std::string_view set, const LimitStateOptions& o)
{
    const auto rule = [](const std::string& rocks, double shear, const char* source) {
        return ", or a drift of " + rocks + " if the wall rocks, " + percent(shear) +
               " if not (" + source + "), whichever comes first";
    };
    if (set == "ntc")
        return {
            o.ntc_limit,
            rule(percent(kNtcRockingDrift), kNtcShearDrift, "Circolare 7/2019, C8.7.1.3.1.1"),
            kNtcLimitGoverns};
    if (set == "ec8")
        return {o.ec8_limit,
                rule(percent(ec8_drift(true, 1.0)) + " x H0/D" +
                         (o.slenderness > 0.0 ? " = " + percent(ec8_drift(true, o.slenderness))
                                              : ""),
                     ec8_drift(false, 1.0),
                     "EN 1998-3:2005, Annex C, primary walls; compare with your copy of the "
                     "code"),
                kEc8LimitGoverns};
    return {0.0, {}, {}};
}

/// The drift limit of the code may come before the fall of the force.
Parts with_limit(const Curve& curve, const CodeLimit& limit, const LimitStateOptions& o,
                 Parts p)
{
    p.ultimate_rule += limit.rule;
    if (p.ultimate.reading == Reading::not_defined) return p;
    const bool falls_first =
        p.ultimate.reading == Reading::observed && p.ultimate.displacement <= limit.at;
    if (falls_first) {
        p.ultimate.reason = "the force falls before the drift limit of the code";
    } else if (curve.displacement.back() >= limit.at) {
        const CutCurve cut(curve, limit.at);
        p.top = peak(cut);
        p.ultimate = {limit.at, Reading::observed, limit.governs};
        p.yield = yield_of(cut, p.ultimate, o);
    }
    return p;
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
    Parts parts = read_parts(curve, options);
    const CodeLimit limit = code_limit(set, options);
    if (limit.at > 0.0) parts = with_limit(curve, limit, options, std::move(parts));
    for (const Set& s : kSets)
        if (s.name == set) return s.read(parts);
    throw std::invalid_argument("limit states: no set " + std::string(set));
}

std::span<const std::string_view> limit_state_sets() { return kNames; }

bool is_capped(const LimitDisplacement& d)
{
    return is_observed(d) && (d.reason == kNtcLimitGoverns || d.reason == kEc8LimitGoverns ||
                              d.reason == kGivenLimitGoverns);
}

} // namespace fragility
