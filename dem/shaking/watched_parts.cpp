#include "dem/shaking/watched_parts.hpp"

#include "dem/block/model.hpp"
#include "dem/contact/pack.hpp"

#include <algorithm>
#include <cmath>

namespace dem {

std::vector<int> top_of(const Model& m)
{
    const int n = static_cast<int>(m.layout.blocks.size());
    if (m.layout.beam < n) return {m.layout.beam};
    std::vector<int> top;
    double highest = 0.0;
    for (const Block& b : m.layout.blocks) highest = std::max(highest, b.z1);
    for (int b = 0; b < n; ++b)
        if (m.layout.blocks[b].z1 > highest - kTouching) top.push_back(b);
    return top;
}

std::vector<ContactRun> foot_of(const StepTables& t, const std::vector<BlockMass>& masses)
{
    constexpr double kLevel = 0.5; // vertical part of the normal of a bed joint: choice
    const auto moves = [&](int b) { return b != kGround && masses[b].mass > 0.0; };
    std::vector<ContactRun> foot;
    for (std::size_t r = 0; r < t.dry.size(); ++r)
        if (std::abs(t.finite.pairs[r].nz) > kLevel &&
            moves(t.dry_blocks[r][0]) != moves(t.dry_blocks[r][1]))
            foot.push_back(t.dry[r]);
    return foot;
}

template <class Real>
double open_share(const StepTables& t, const std::vector<ContactRun>& runs,
                  const WallState<Real>& s, int lane)
{
    double all = 0.0, open = 0.0; // [m2]
    for (const ContactRun& run : runs)
        for (int k = run.first; k < run.first + run.count; ++k) {
            all += t.area[k];
            if (dem::lane(s.u_n[k], lane) > 0.0) open += t.area[k];
        }
    return all > 0.0 ? open / all : 0.0;
}

template <class Real>
bool overturned(const Layout& l, const std::vector<BlockMass>& masses,
                const FiniteState<Real>& s, int lane)
{
    double turned = 0.0, weight = 0.0;
    for (std::size_t b = 0; b < masses.size(); ++b) {
        weight += masses[b].mass;
        turned += masses[b].mass * dem::lane(s.frames[b].turn, lane);
    }
    return weight > 0.0 && std::abs(turned / weight) > std::atan2(l.length, l.height);
}

template double open_share(const StepTables&, const std::vector<ContactRun>&,
                           const WallState<double>&, int);
template double open_share(const StepTables&, const std::vector<ContactRun>&,
                           const WallState<Pack>&, int);
template bool overturned(const Layout&, const std::vector<BlockMass>&,
                         const FiniteState<double>&, int);
template bool overturned(const Layout&, const std::vector<BlockMass>&, const FiniteState<Pack>&,
                         int);

} // namespace dem
