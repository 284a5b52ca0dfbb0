#include "app/study/pushed/pier_facts.hpp"

#include "app/input/study/study.hpp"
#include "app/study/pushed/pushed_wall.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace app {
namespace {

/// H0 / D, from the moments at both ends.
double slenderness_of(const dem::Pier& p, const dem::CutForce& f, double most)
{
    if (f.shear == 0.0) return most;
    const double top = f.moment - (p.at.z1 - p.cut) * f.shear,
                 bottom = f.moment + (p.cut - p.at.z0) * f.shear;
    const double span = std::max(std::abs(top), std::abs(bottom)) / std::abs(f.shear);
    return std::min(most, span / (p.at.x1 - p.at.x0));
}

/// The instants of the points of a curve: forces of both are the same means.
class Instants {
  public:
    explicit Instants(const PierHistory& history) : history_(history) {}
    /// Shear of a pier [N]; between two instants, as the first points of a push are, along the
    /// line through theirs. Points are asked for in their order.
    double shear_at(const dem::CurvePoint& point, std::size_t pier)
    {
        for (std::size_t k = next_; k < std::min(next_ + kAhead, history_.size()); ++k)
            if (history_[k].force == point.force) {
                next_ = k;
                return shear(k, pier);
            }
        if (next_ + 1 == history_.size()) return shear(next_, pier);
        const double from = history_[next_].displacement, to = history_[next_ + 1].displacement;
        const double share =
            to == from ? 0.0 : std::clamp((point.displacement - from) / (to - from), 0.0, 1.0);
        return (1.0 - share) * shear(next_, pier) + share * shear(next_ + 1, pier);
    }

  private:
    double shear(std::size_t k, std::size_t pier) const
    {
        return history_[k].piers[pier].force.shear;
    }

    static constexpr std::size_t kAhead = 3;
    const PierHistory& history_;
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

double single(double x) { return double{static_cast<float>(x)}; }

PierFacts facts_of(const LoadInput& load, double drop, const dem::PierProbe& probe,
                   const PierHistory& history, const PierHistory& calm, std::size_t i,
                   const PushedWall& wall, const dem::Snapshot& moved)
{
    PierFacts f;
    const dem::Pier& pier = probe.piers().piers[i];
    const double way = push_way(load).direction;
    const dem::PierState peak = calm[at_peak(calm)].piers[i];
    f.normal_before = history.front().piers[i].force.normal;
    f.normal_at_peak = peak.force.normal;
    f.shear_at_peak = way * peak.force.shear;
    f.end_movement = way * history.back().piers[i].displacement;
    Instants instants(history);
    for (const dem::CurvePoint& p : wall.result.curve) {
        f.movement.push_back(single(way * movement_at(history, i, way * p.displacement, way)));
        f.shear.push_back(single(way * instants.shear_at(p, i)));
    }
    const dem::PierState* strongest = &calm.front().piers[i];
    for (const PierInstant& now : calm)
        if (way * now.piers[i].force.shear > way * strongest->force.shear)
            strongest = &now.piers[i];
    f.most_shear = way * strongest->force.shear;
    f.slenderness =
        slenderness_of(pier, strongest->force, load.height / (pier.at.x1 - pier.at.x0));
    const auto own = movement_at_drop(calm, i, way, drop);
    const PierMovement m = own ? *own : pier_movement(probe, i, moved);
    f.moved = m.moved ? 1.0 : 0.0;
    f.mechanism = m.mechanism;
    return f;
}

} // namespace

std::vector<PierFacts> pier_facts(const LoadInput& load, double drop,
                                  const dem::PierProbe& probe, const PierHistory& history,
                                  const PierHistory& calm, const PushedWall& wall,
                                  const dem::Snapshot& moved)
{
    std::vector<PierFacts> facts;
    for (std::size_t i = 0; i < probe.piers().piers.size(); ++i)
        facts.push_back(facts_of(load, drop, probe, history, calm, i, wall, moved));
    return facts;
}

std::vector<SpandrelFacts> spandrel_facts(const PierHistory& history, const PierHistory& calm)
{
    std::vector<SpandrelFacts> facts;
    for (std::size_t i = 0; i < history.front().spandrels.size(); ++i) {
        const dem::CutForce peak = calm[at_peak(calm)].spandrels[i].force;
        SpandrelFacts f{peak.normal, peak.shear, 0.0, history.back().spandrels[i].drop};
        for (const PierInstant& now : calm)
            f.most_shear = std::max(f.most_shear, std::abs(now.spandrels[i].force.shear));
        facts.push_back(f);
    }
    return facts;
}

} // namespace app
