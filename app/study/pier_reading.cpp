#include "app/study/pier_reading.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/study/pier_remark.hpp"
#include "app/study/pushed_wall.hpp"
#include "fragility/drift.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace app {
namespace {

using fragility::LimitDisplacement;
using fragility::Reading;

constexpr double kNever = 1e9; ///< [m]: a limit that no wall reaches

/// Where the load line is when a pier first reaches a movement of its own.
LimitDisplacement wall_at(const PierHistory& history, std::size_t pier, double movement,
                          double way)
{
    double before = way * history.front().piers[pier].displacement,
           wall_before = way * history.front().displacement;
    for (const PierInstant& now : history) {
        const double moved = way * now.piers[pier].displacement, wall = way * now.displacement;
        if (moved >= movement) {
            const double share = moved > before ? (movement - before) / (moved - before) : 1.0;
            return {wall_before + std::max(share, 0.0) * (wall - wall_before),
                    Reading::observed,
                    {}};
        }
        before = moved;
        wall_before = wall;
    }
    return {wall_before, Reading::censored, "the push ended before"};
}

/// The movement by which the mode of the wall is read (pushed_wall.cpp).
dem::Snapshot telling(const dem::PushResult& r)
{
    return r.at_half ? dem::movement_since(*r.at_half, r.at_end) : r.at_drop.value_or(r.at_end);
}

/// H0 / D, from the moments at both ends.
double slenderness_of(const dem::Pier& p, const dem::CutForce& f, double most)
{
    if (f.shear == 0.0) return most;
    const double top = f.moment - (p.at.z1 - p.cut) * f.shear,
                 bottom = f.moment + (p.cut - p.at.z0) * f.shear;
    const double span = std::max(std::abs(top), std::abs(bottom)) / std::abs(f.shear);
    return std::min(most, span / (p.at.x1 - p.at.x0));
}

std::size_t at_peak(const PierHistory& history)
{
    const auto most = std::ranges::max_element(
        history, {}, [](const PierInstant& i) { return std::abs(i.force); });
    return static_cast<std::size_t>(most - history.begin());
}

/// Where the load line was in the middle of the steps that the forces of an instant are means
/// of: at the point of the curve that has its force.
class MeanPlaces {
  public:
    explicit MeanPlaces(const std::vector<dem::CurvePoint>& curve) : curve_(curve) {}
    /// [m]; instants are asked for in their order.
    double next(const PierInstant& now)
    {
        for (std::size_t p = next_; p < curve_.size(); ++p)
            if (curve_[p].force == now.force) {
                next_ = p + 1;
                return curve_[p].displacement;
            }
        return now.displacement;
    }

  private:
    const std::vector<dem::CurvePoint>& curve_;
    std::size_t next_ = 0;
};

/// Movement of a pier where the load line was at `place`, which is way times that place [m].
double movement_at(const PierHistory& history, std::size_t pier, double place, double way)
{
    const auto after = std::ranges::lower_bound(
        history, place, {}, [way](const PierInstant& p) { return way * p.displacement; });
    if (after == history.end()) return history.back().piers[pier].displacement;
    const double b = after->piers[pier].displacement, at = way * after->displacement;
    if (after == history.begin()) return b;
    const auto before = std::prev(after);
    const double a = before->piers[pier].displacement, from = way * before->displacement;
    return a + (place - from) / (at - from) * (b - a);
}

PierReading read_pier(const Study& study, const dem::PierProbe& probe,
                      const PierHistory& history, const PierHistory& calm, std::size_t i,
                      const PushedWall& wall, const dem::Snapshot& moved, bool came_down)
{
    constexpr double kMoves = 1e-4; // [-], of its height: a pier that stands still has no mode
    PierReading r;
    r.pier = probe.piers().piers[i];
    const double way = push_way(study).direction, height = r.pier.at.z1 - r.pier.at.z0;
    const dem::PierState peak = calm[at_peak(calm)].piers[i];
    r.normal_before = history.front().piers[i].force.normal;
    r.normal_at_peak = peak.force.normal;
    r.shear_at_peak = way * peak.force.shear;
    r.drift = fragility::drift(way * history.back().piers[i].displacement, height);
    std::vector<double> displacement, force;
    MeanPlaces means(wall.result.curve);
    for (const PierInstant& now : history) {
        displacement.push_back(way * movement_at(history, i, way * means.next(now), way));
        force.push_back(way * now.piers[i].force.shear);
    }
    const dem::PierState* strongest = &calm.front().piers[i];
    for (const PierInstant& now : calm)
        if (way * now.piers[i].force.shear > way * strongest->force.shear)
            strongest = &now.piers[i];
    r.most_shear = way * strongest->force.shear;
    constexpr double kCarries = 0.05; // of the wall's largest force: a free choice
    r.carries = r.most_shear >= kCarries * std::abs(history[at_peak(history)].force);
    r.slenderness = slenderness_of(r.pier, strongest->force,
                                   study.load.height / (r.pier.at.x1 - r.pier.at.x0));
    const dem::Snapshot alone = probe.alone(i, moved);
    dem::Mechanism mechanism;
    r.moved = !alone.blocks.empty() && std::abs(alone.displacement) > kMoves * height;
    if (r.moved) mechanism = dem::mechanism(alone, height);

    ReadingRules rules = reading_rules(study);
    rules.height = height;
    rules.slenderness = r.slenderness;
    rules.direction = 0; // its movement may come back
    rules.backbone = fragility::Side::right;
    r.own = read({displacement, force, came_down}, mechanism, rules, true);
    r.mode = code_mode(mechanism, r.own.dropped, rules.mode);
    for (const fragility::Code& code : pier_codes(study))
        for (const fragility::CodeState& state : code.states) {
            if (state.drifts.empty()) continue;
            const double drift = fragility::drift_limit(state, name(r.mode), r.slenderness);
            r.caps.push_back(
                {code.name, state.name, drift,
                 drift > 0.0 ? wall_at(history, i, drift * height, way) : LimitDisplacement{}});
        }
    return r;
}

SpandrelReading read_spandrel(const dem::PierProbe& probe, const PierHistory& history,
                              std::size_t i)
{
    SpandrelReading r;
    r.spandrel = probe.piers().spandrels[i];
    const dem::CutForce peak = history[at_peak(history)].spandrels[i];
    r.normal_at_peak = peak.normal;
    r.shear_at_peak = peak.shear;
    for (const PierInstant& now : history)
        r.most_shear = std::max(r.most_shear, std::abs(now.spandrels[i].shear));
    return r;
}

struct StoreySum {
    double shear = 0.0, normal = 0.0; ///< [N]
};

StoreySum sum_of(const dem::Piers& all, const PierInstant& now, int storey)
{
    StoreySum sum;
    for (std::size_t i = 0; i < all.piers.size(); ++i)
        if (all.piers[i].storey == storey) {
            sum.shear += now.piers[i].force.shear;
            sum.normal += now.piers[i].force.normal;
        }
    return sum;
}

PierBalance balance_of(const dem::Piers& all, const PierHistory& history)
{
    PierBalance b;
    double most = 0.0;
    for (const PierInstant& now : history) most = std::max(most, std::abs(now.base_shear));
    for (int storey = 1; storey <= all.piers.back().storey; ++storey) {
        const double before = sum_of(all, history.front(), storey).normal;
        for (const PierInstant& now : history) {
            const StoreySum sum = sum_of(all, now, storey);
            b.shear = std::max(b.shear, std::abs(sum.shear - now.base_shear) / most);
            b.normal = std::max(b.normal, std::abs(sum.normal - before) / std::abs(before));
        }
    }
    return b;
}

/// By set and limit state, where the load line is when a pier first reaches its limit [m].
std::vector<std::vector<double>> caps_by_piers(const ReadingRules& rules,
                                               const std::vector<PierReading>& piers)
{
    std::vector<std::vector<double>> caps;
    for (const fragility::Code& code : rules.sets) {
        caps.emplace_back();
        for (const fragility::CodeState& state : code.states) {
            const int first = governing_pier(piers, code.name, state.name);
            caps.back().push_back(
                state.drifts.empty() ? 0.0
                : first == 0
                    ? kNever
                    : cap_of(piers[static_cast<std::size_t>(first) - 1], code.name, state.name)
                          ->wall.displacement);
        }
    }
    return caps;
}

} // namespace

std::string_view mode_text(const PierReading& pier)
{
    if (!pier.moved) return "stands still";
    return pier.carries ? name(pier.mode) : "carries little";
}

bool tells_piers(const Study& study)
{
    return push_way(study).direction != 0 && has_piers(study);
}

const PierCap* cap_of(const PierReading& pier, std::string_view code, std::string_view state)
{
    for (const PierCap& cap : pier.caps)
        if (cap.code == code && (state.empty() || cap.state == state)) return &cap;
    return nullptr;
}

int governing_pier(const std::vector<PierReading>& piers, std::string_view code,
                   std::string_view state)
{
    int first = 0;
    double least = kNever;
    for (std::size_t i = 0; i < piers.size(); ++i) {
        const PierCap* const cap = cap_of(piers[i], code, state);
        if (cap == nullptr || !piers[i].carries || !is_observed(cap->wall)) continue;
        if (cap->wall.displacement >= least) continue;
        least = cap->wall.displacement;
        first = static_cast<int>(i) + 1;
    }
    return first;
}

void read_piers(const Study& study, const dem::PierProbe& probe, const PierHistory& history,
                PushedWall& wall)
{
    if (dem::failed(wall.result.outcome) || came_down_at_once(wall) || history.size() < 2)
        return;
    const dem::Snapshot moved = telling(wall.result);
    const PierHistory calm = calmed(history, kCalm * study.load.height);
    const bool came_down = wall.result.outcome == dem::Outcome::lost_equilibrium;
    for (std::size_t i = 0; i < probe.piers().piers.size(); ++i)
        wall.piers.push_back(read_pier(study, probe, history, calm, i, wall, moved, came_down));
    for (std::size_t i = 0; i < probe.piers().spandrels.size(); ++i)
        wall.spandrels.push_back(read_spandrel(probe, calm, i));
    if (wall.piers.empty()) return;
    wall.pier_balance = balance_of(probe.piers(), calm);
    if (study.load.pattern == dem::LoadPattern::body)
        wall.pier_balance.shear = std::numeric_limits<double>::quiet_NaN();
    ReadingRules rules = reading_rules(study);
    rules.by_piers = true;
    rules.pier_caps = caps_by_piers(rules, wall.piers);
    wall.reading = read({wall.displacement, wall.force, came_down}, wall.mechanism, rules,
                        wall.result.settled);
}

} // namespace app
