#include "dem/solver/state/finite_state.hpp"

#include "dem/block/model.hpp"

#include <cstddef>

namespace dem {

namespace {

template <class Real>
void copy(const std::vector<double>& from, int lane, std::vector<Real>& to)
{
    for (std::size_t i = 0; i < from.size(); ++i) set_lane(to[i], lane, from[i]);
}

template <class Real> void copy(const BlockFrame<double>& from, int lane, BlockFrame<Real>& to)
{
    set_lane(to.x, lane, from.x);
    set_lane(to.z, lane, from.z);
    set_lane(to.turn, lane, from.turn);
    set_lane(to.half.c, lane, from.half.c);
    set_lane(to.half.s, lane, from.half.s);
    set_lane(to.vx, lane, from.vx);
    set_lane(to.vz, lane, from.vz);
    set_lane(to.spin, lane, from.spin);
    set_lane(to.fx, lane, from.fx);
    set_lane(to.fz, lane, from.fz);
    set_lane(to.moment, lane, from.moment);
}

template <class Real>
void copy(const FiniteState<double>::Pair& from, int lane, typename FiniteState<Real>::Pair& to)
{
    set_lane(to.gap, lane, from.gap);
    set_lane(to.widening, lane, from.widening);
    set_lane(to.share, lane, from.share);
    set_lane(to.slip, lane, from.slip);
    set_lane(to.past_far, lane, from.past_far);
    set_lane(to.past_near, lane, from.past_near);
    set_lane(to.centre, lane, from.centre);
}

} // namespace

template <class Real>
FiniteState<Real> undeformed(const FiniteTables& t, int modes, int contacts, bool crushes,
                             bool closes)
{
    FiniteState<Real> s;
    s.frames.resize(t.blocks.size() + 1);
    s.weight.assign(t.blocks.size(), Real(0.0));
    s.sway.assign(modes, Real(0.0));
    s.acting.assign(static_cast<std::size_t>(2) * contacts, Real(0.0));
    s.pairs.resize(t.pairs.size());
    s.further.resize(t.further.size());
    s.further_u_n.assign(t.further.size() * t.most_points, Real(0.0));
    s.further_tau = s.further_u_n;
    if (crushes) s.further_crushed = s.further_u_n;
    if (closes) s.further_shear = s.further_rest = s.further_u_n;
    for (int i = 0; i < lanes<Real>; ++i) clear_lane(t, i, s);
    return s;
}

template <class Real> void clear_lane(const FiniteTables& t, int lane, FiniteState<Real>& s)
{
    const FiniteState<double>::Pair closed;
    FiniteState<double>::Pair apart;
    apart.share = 0.0;
    for (std::size_t b = 0; b < t.blocks.size(); ++b) {
        BlockFrame<double> frame;
        frame.x = t.blocks[b].x;
        frame.z = t.blocks[b].z;
        copy(frame, lane, s.frames[b]);
        set_lane(s.weight[b], lane, 0.0);
    }
    copy(BlockFrame<double>{}, lane, s.frames[t.ground]);
    for (auto* values : {&s.sway, &s.acting, &s.further_u_n, &s.further_tau, &s.further_crushed,
                         &s.further_shear, &s.further_rest})
        for (Real& x : *values) set_lane(x, lane, 0.0);
    for (auto& p : s.pairs) copy<Real>(closed, lane, p);
    for (auto& p : s.further) copy<Real>(apart, lane, p);
    set_lane(s.vertical, lane, 0.0);
}

template <class Real>
void load_lane(const Model& m, const FiniteTables& t, const WallMaterials& w, int lane,
               FiniteState<Real>& s)
{
    clear_lane(t, lane, s);
    for (std::size_t b = 0; b < t.blocks.size(); ++b) {
        const Elastic& material = stone_of(m, static_cast<int>(b), w.stone);
        const double pull = material.density * m.loads.gravity; // [N/m3]
        set_lane(s.weight[b], lane, pull * t.blocks[b].volume);
        const BlockElement& e = m.elements[m.places[b].element];
        for (Eigen::Index i = 0; i < e.sway.size(); ++i)
            set_lane(s.sway[m.places[b].first_mode + i], lane, pull * e.sway(i));
    }
    set_lane(s.vertical, lane,
             w.vertical_stress.value_or(m.loads.vertical_stress) * t.load_area);
}

template <class Real>
void copy_to_lane(const FiniteState<double>& wall, int lane, FiniteState<Real>& s)
{
    for (std::size_t b = 0; b < wall.frames.size(); ++b)
        copy(wall.frames[b], lane, s.frames[b]);
    copy(wall.weight, lane, s.weight);
    copy(wall.sway, lane, s.sway);
    copy(wall.acting, lane, s.acting);
    copy(wall.further_u_n, lane, s.further_u_n);
    copy(wall.further_tau, lane, s.further_tau);
    copy(wall.further_crushed, lane, s.further_crushed);
    copy(wall.further_shear, lane, s.further_shear);
    copy(wall.further_rest, lane, s.further_rest);
    for (std::size_t p = 0; p < wall.pairs.size(); ++p)
        copy<Real>(wall.pairs[p], lane, s.pairs[p]);
    for (std::size_t p = 0; p < wall.further.size(); ++p)
        copy<Real>(wall.further[p], lane, s.further[p]);
    set_lane(s.vertical, lane, wall.vertical);
}

template FiniteState<double> undeformed(const FiniteTables&, int, int, bool, bool);
template void load_lane(const Model&, const FiniteTables&, const WallMaterials&, int,
                        FiniteState<double>&);
template void clear_lane(const FiniteTables&, int, FiniteState<double>&);
template void copy_to_lane(const FiniteState<double>&, int, FiniteState<double>&);
template FiniteState<Pack> undeformed(const FiniteTables&, int, int, bool, bool);
template void load_lane(const Model&, const FiniteTables&, const WallMaterials&, int,
                        FiniteState<Pack>&);
template void clear_lane(const FiniteTables&, int, FiniteState<Pack>&);
template void copy_to_lane(const FiniteState<double>&, int, FiniteState<Pack>&);

} // namespace dem
