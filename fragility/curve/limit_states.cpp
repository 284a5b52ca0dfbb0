#include "fragility/curve/limit_states.hpp"

#include "fragility/curve/first_loading.hpp"
#include "fragility/curve/state_parts.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace fragility {
namespace {

/// Parts that limit states are read at.
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

/// Up to a censored ultimate displacement the yield is a bound that holds however the push goes
/// on.
LimitDisplacement yield_of(const Curve& curve, const LimitDisplacement& ultimate,
                           const LimitStateOptions& o)
{
    if (ultimate.reading == Reading::not_defined) return ultimate;
    if (!o.no_yield.empty()) return {0.0, Reading::not_defined, o.no_yield};
    if (o.residual != 0.0) {
        const Backbone own = from_own_zero(curve, o.residual);
        LimitDisplacement end = ultimate;
        end.displacement += o.residual;
        if (!(end.displacement > 0.0))
            return {0.0, Reading::not_defined, reason(BilinearOutcome::no_elastic_branch)};
        LimitStateOptions rest = o;
        rest.residual = 0.0;
        if (o.reach > 0.0) rest.reach += o.residual;
        return yield_of({own.displacement, own.force}, end, rest);
    }
    const double share = share_within(curve, o.reach, o.bilinear_share);
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

/// The drift limit of the code may come before the fall of the force.
Parts with_limit(const Curve& curve, double limit, std::string_view governs,
                 const LimitStateOptions& o, Parts p)
{
    if (p.ultimate.reading == Reading::not_defined) return p;
    const bool falls_first =
        p.ultimate.reading == Reading::observed && p.ultimate.displacement <= limit;
    if (falls_first) {
        p.ultimate.reason = "the force falls before the drift limit of the code";
    } else if (curve.displacement.back() >= limit) {
        const CutCurve cut(curve, limit);
        p.top = peak(cut);
        p.ultimate = {limit, Reading::observed, governs};
        p.yield = yield_of(cut, p.ultimate, o);
    }
    return p;
}

LimitDisplacement yield_or_peak(const Parts& p)
{
    if (p.yield.reading != Reading::not_defined && p.top.displacement < p.yield.displacement)
        return {p.top.displacement, Reading::observed, "the peak comes before the yield"};
    return p.yield;
}

/// A limit state that is no share of another one, without its drift limit.
LimitDisplacement part_of(const Curve& curve, const CodeState& s, const Parts& p,
                          const LimitStateOptions& o)
{
    switch (s.part) {
    case CodePart::yield:
        return scaled(p.yield, s.factor);
    case CodePart::yield_or_peak:
        return scaled(yield_or_peak(p), s.factor);
    case CodePart::peak:
        return scaled(at_peak(p.top), s.factor);
    case CodePart::ultimate:
        return scaled(p.ultimate, s.factor);
    case CodePart::collapse:
        return scaled(p.collapse, s.factor);
    case CodePart::rise:
        return rise_to(curve, s.factor);
    case CodePart::drop:
        return drop_after_peak(curve, s.factor, o.crossing);
    default:
        return {};
    }
}

/// "3/4 of "
std::string share_text(const CodeState& s)
{
    return s.factor_text.empty() ? "" : s.factor_text + " of ";
}

std::string part_text(const CodeState& s, const Parts& p, const LimitStateOptions& o)
{
    const std::string share = share_text(s);
    switch (s.part) {
    case CodePart::yield:
        return share + p.bilinear_rule;
    case CodePart::yield_or_peak:
        return share + p.bilinear_rule + ", or the peak if it comes first";
    case CodePart::peak:
        return share + "the displacement at the peak";
    case CodePart::ultimate:
        return share + p.ultimate_rule;
    case CodePart::collapse:
        return share + "no force is left after the peak, or the wall comes down";
    case CodePart::rise:
        return "first rise to " + percent(s.factor) + " of the peak";
    case CodePart::drop:
        return std::string(o.crossing == Crossing::first ? "first" : "last") + " drop to " +
               percent(s.factor) + " of the peak";
    case CodePart::state:
        return share + s.of_name;
    default:
        return {};
    }
}

std::string rule_text(const CodeState& s, const Parts& p, const LimitStateOptions& o)
{
    std::string text = part_text(s, p, o);
    if (s.drifts.empty()) return text;
    const bool alone = s.part == CodePart::none;
    if (!alone) text += ", or ";
    text += drift_text(s, o.slenderness) + " (" + source_text(s) + ")";
    return alone ? text : text + ", whichever comes first";
}

double cap_of(std::span<const double> caps, std::size_t state)
{
    return state < caps.size() ? caps[state] : 0.0;
}

LimitDisplacement no_drift_limit()
{
    return {0.0, Reading::not_defined, "the code limits no drift of this mode"};
}

bool cuts_the_curve(const CodeState& s)
{
    return s.part == CodePart::ultimate && s.factor_text.empty();
}

} // namespace

CurveParts curve_parts(const Curve& curve, const LimitStateOptions& options)
{
    const Parts p = read_parts(curve, options);
    return {p.yield, p.ultimate};
}

std::vector<LimitState> read_limit_states(const Curve& curve, const Code& code,
                                          std::span<const double> caps,
                                          const LimitStateOptions& options)
{
    if (code.states.empty())
        throw std::invalid_argument("limit states: nothing is given of " + code.name);
    Parts p = read_parts(curve, options);
    for (std::size_t i = 0; i < code.states.size(); ++i)
        if (cuts_the_curve(code.states[i]) && cap_of(caps, i) > 0.0)
            p = with_limit(curve, cap_of(caps, i), code.states[i].governs, options, p);
    std::vector<LimitState> found;
    for (std::size_t i = 0; i < code.states.size(); ++i) {
        const CodeState& s = code.states[i];
        LimitDisplacement limit = part_of(curve, s, p, options);
        const double cap = cap_of(caps, i);
        if (s.part == CodePart::none)
            limit = cap > 0.0 ? cap_alone(curve, cap, s.governs) : no_drift_limit();
        else if (cap > 0.0 && !cuts_the_curve(s) && s.part != CodePart::state)
            limit = capped(curve, limit, cap, s.governs);
        found.push_back({s.name, rule_text(s, p, options), limit});
    }
    for (std::size_t i = 0; i < code.states.size(); ++i) {
        const CodeState& s = code.states[i];
        if (s.part != CodePart::state) continue;
        found[i].limit = scaled(found[static_cast<std::size_t>(s.of)].limit, s.factor);
        if (cap_of(caps, i) > 0.0)
            found[i].limit = capped(curve, found[i].limit, cap_of(caps, i), s.governs);
    }
    return found;
}

bool is_capped(const LimitDisplacement& d)
{
    return is_observed(d) &&
           (d.reason.starts_with("governed by ") || d.reason == kGivenLimitGoverns);
}

} // namespace fragility
