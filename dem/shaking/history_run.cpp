#include "dem/shaking/history_run.hpp"

#include "dem/block/model.hpp"
#include "dem/contact/pack.hpp"
#include "dem/shaking/shaking_start.hpp"
#include "dem/shaking/watched_parts.hpp"
#include "dem/solver/state/take_snapshot.hpp"
#include "dem/solver/step/vertical_load.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace dem {

namespace {

constexpr double kLedger = 0.01; // [-] error of the energy balance that is borne
constexpr double kLeastPassed =
    1e-4; // energy that the balance is a share of, over load times height
// Share of a contact's own limit at which one that opens and closes keeps its energy; of one
// that closes, whose stiffness is not known beforehand.
constexpr double kContactShare = 0.25, kClosingShare = 0.2;
// With dashpots k + 2 d <= 4 in units of the step, k being 4 at the largest stable one and d at
// most 1: a share of 0.7 of that step always is stable.
constexpr double kDampedFraction = 0.7, kDampedBound = 3.96;
constexpr double kFractionStep = 0.99; // between shares of the step that are tried
constexpr int kMostReductions = 6;
// The step of a wall whose joints close allows for this many times their stiffness at rest. It
// is a free choice: where joints become much stiffer, the ledger asks for a smaller step.
constexpr double kStiffer = 4.0;
constexpr long long kLookEvery = 50;
constexpr double kUsualFreeVibration = 5.0; // [s] hardly a wall moves longer

/// Share of a history that is done, at most 1.
double share_done(const ShakingClock& clock)
{
    const double usual = static_cast<double>(clock.record) + kUsualFreeVibration / clock.dt;
    const double all = std::min(usual, static_cast<double>(clock.last));
    return std::min(1.0, static_cast<double>(clock.step) / all);
}

} // namespace

HistoryRun::HistoryRun(const ShakenTask& task, std::size_t number, WallMaterials materials,
                       ShakePlan plan)
    : task_(&task), number_(number), materials_(std::move(materials)), plan_(std::move(plan)),
      options_(task.options), fraction_(plan_.step_fraction),
      load_(vertical_load(task.model, materials_)), top_blocks_(top_of(task.model))
{
    check(plan_);
    if (plan_.contact_damping > 0.0 && task.model.layout.closure != Closure::linear)
        throw std::invalid_argument("joints that close have no dashpots: they lose energy by "
                                    "their closure loss; leave contact damping out");
    masses_ = true_masses(task.model, task.tables, materials_, plan_.load, plan_.load_height);
    foot_ = foot_of(task.tables, masses_);
    options_.kinematics = Kinematics::finite;
    for (const double a : plan_.horizontal) peak_ = std::max(peak_, std::abs(a));
}

/// Largest share of the stable step that dashpots of this strength allow.
double HistoryRun::damped_fraction(const StepLimits& limits) const
{
    double fraction = fraction_;
    for (; fraction > kDampedFraction; fraction *= kFractionStep) {
        const std::vector<double> shares =
            dashpot_shares(task_->model, task_->tables, materials_, masses_, limits,
                           plan_.contact_damping, fraction * limits.whole);
        const double most = *std::ranges::max_element(shares);
        if (4.0 * fraction * fraction * (1.0 + 2.0 * most) <= kDampedBound) break;
    }
    return fraction;
}

void HistoryRun::set_clock(const StepLimits& limits)
{
    options_.step_fraction = fraction_;
    if (plan_.contact_damping > 0.0 && !task_->tables.dry.empty())
        options_.step_fraction = damped_fraction(limits);
    double most = options_.step_fraction * limits.whole;
    if (plan_.contact_damping == 0.0) {
        const bool closes = task_->model.layout.closure != Closure::linear;
        const double share = (closes ? kClosingShare : kContactShare) * fraction_;
        most = std::min(most, share / plan_.step_fraction * limits.contact);
    }
    clock_ = shaking_clock(plan_, most);
    free_ = FreeVibration(clock_);
    r_.time_step = clock_.dt;
}

template <class Real> bool HistoryRun::load(ShakenWalls<Real>& walls, int lane)
{
    const Model& m = task_->model;
    const StepTables& t = task_->tables;
    const double stiffer = m.layout.closure == Closure::linear ? 1.0 : kStiffer;
    const StepLimits limits = step_limits(m, t, materials_, masses_, stiffer);
    set_clock(limits);
    ShakingStart start = plan_.released.empty()
                             ? wall_at_rest(m, t, materials_, options_)
                             : released_wall(m, t, materials_, options_, plan_.released);
    r_.peak_ground = peak_;
    r_.unbalance = start.unbalance;
    raised_ = start.raised;
    ledger_ = HistoryLedger(start.wall.work, kLeastPassed * m.layout.height * load_);
    SolverOptions moving = options_;
    moving.step_fraction *= limits.whole / limits.elastic;
    moving.damping_factor = 0.0;
    load_lane(m, t, materials_, moving, start.wall, masses_, clock_.dt, lane, walls);
    if (!start.at_rest) {
        r_.outcome = ShakeOutcome::unsettled;
        return false;
    }
    if (plan_.contact_damping > 0.0)
        set_dashpots(
            dashpot_shares(m, t, materials_, masses_, limits, plan_.contact_damping, clock_.dt),
            lane, walls.state);
    find_top(walls.state, lane);
    for (std::size_t k = 0; k < m.dry.size(); ++k)
        open_.push_back(dem::lane(walls.state.u_n[k], lane) > 0.0);
    watch(walls, lane);
    return clock_.step < clock_.last;
}

template <class Real> void HistoryRun::find_top(const WallState<Real>& s, int lane)
{
    const auto n = static_cast<double>(top_blocks_.size());
    for (const int b : top_blocks_) r_.top_height += dem::lane(s.finite.frames[b].z, lane);
    r_.top_height /= n;
    if (plan_.released.empty()) {
        top_x_ = displacement(s, lane);
        return;
    }
    for (const int b : top_blocks_) top_x_ += task_->tables.finite.blocks[b].x;
    top_x_ /= n;
}

ShakingInput<double> HistoryRun::next() const
{
    return {ground_now(plan_.horizontal, clock_), ground_now(plan_.vertical, clock_),
            clock_.step == 0 ? 0.5 : 1.0};
}

template <class Real> double HistoryRun::displacement(const WallState<Real>& s, int lane) const
{
    double sum = 0.0;
    for (const int b : top_blocks_) sum += dem::lane(s.finite.frames[b].x, lane);
    return sum / static_cast<double>(top_blocks_.size()) - top_x_;
}

template <class Real> Snapshot HistoryRun::snapshot(const WallState<Real>& s, int lane) const
{
    return take_snapshot(task_->model, task_->tables, s, lane, top_u_,
                         dem::lane(s.base_shear, lane));
}

/// Maxima, points and pictures of the wall as it is before a step.
template <class Real> void HistoryRun::watch(const ShakenWalls<Real>& walls, int lane)
{
    const WallState<Real>& s = walls.state;
    const double time = clock_.time(), slack = 0.5 * clock_.dt;
    top_u_ = displacement(s, lane);
    if (clock_.step == 0 || std::abs(top_u_) > r_.most_displacement) {
        r_.most_displacement = std::abs(top_u_);
        r_.most_at = time;
        further_ = true;
    } else if (further_) { // the wall has just turned back, a step ago
        further_ = false;
        r_.at_most = snapshot(s, lane);
    }
    if (time >= next_point_ - slack) {
        r_.history.push_back({time, ground_now(plan_.horizontal, clock_), top_u_,
                              dem::lane(s.base_shear, lane)});
        next_point_ += plan_.record_every;
    }
    if (plan_.snapshot_every > 0.0 && time >= next_snapshot_ - slack) {
        r_.snapshots.push_back(snapshot(s, lane));
        r_.snapshot_times.push_back(time);
        next_snapshot_ += plan_.snapshot_every;
    }
    free_.add(clock_, top_u_);
}

template <class Real> bool HistoryRun::look(ShakenWalls<Real>& walls, int lane)
{
    bool over = false;
    if (clock_.step % kLookEvery == 0) {
        judge(walls, lane);
        if (wants_smaller_step()) {
            start_again();
            return load(walls, lane);
        }
        over = r_.outcome != ShakeOutcome::stood || (clock_.step > clock_.record && r_.still);
    }
    if (over) return false;
    ++clock_.step;
    watch(walls, lane);
    return clock_.step < clock_.last &&
           !free_.quiet(clock_, plan_.quiet * task_->model.layout.height);
}

/// Energy balance, openings and collapse, now and then.
template <class Real> void HistoryRun::judge(const ShakenWalls<Real>& walls, int lane)
{
    judge_energy(walls, lane);
    if (r_.outcome != ShakeOutcome::stood) return;
    const double time = clock_.time();
    for (std::size_t k = 0; k < open_.size(); ++k) {
        const bool open = dem::lane(walls.state.u_n[k], lane) > 0.0;
        if (open_[k] == open) continue;
        open_[k] = open;
        r_.last_opening = time;
        if (r_.first_opening == 0.0) r_.first_opening = time;
    }
    r_.uplift = std::max(r_.uplift, open_share(task_->tables, foot_, walls.state, lane));
    if (plan_.progress && clock_.step % (100 * kLookEvery) == 0)
        plan_.progress(share_done(clock_), top_u_);
    if (!collapsed(walls, lane)) return;
    r_.outcome = ShakeOutcome::collapsed;
    r_.collapse_time = time;
}

template <class Real> void HistoryRun::judge_energy(const ShakenWalls<Real>& walls, int lane)
{
    HistoryEnergy e{energy_of(task_->tables, walls.state, lane),
                    dem::lane(walls.ground_work, lane), dem::lane(walls.fall_work, lane)};
    e.all.kinetic += dem::lane(kinetic_energy(task_->tables, walls), lane);
    if (!ledger_.read(e)) {
        r_.outcome = ShakeOutcome::not_finite;
        return;
    }
    r_.energy = e.all;
    r_.residual = ledger_.residual();
    r_.still = ledger_.still();
    if (r_.residual > kLedger) r_.outcome = ShakeOutcome::energy_astray;
}

template <class Real> bool HistoryRun::collapsed(const ShakenWalls<Real>& walls, int lane) const
{
    const double height = task_->model.layout.height;
    if (dem::lane(walls.fall_work, lane) - raised_ > kCameDown * height * load_) return true;
    return std::ranges::any_of(walls.state.u_n,
                               [&](const Real& u) { return dem::lane(u, lane) > height; });
}

bool HistoryRun::wants_smaller_step() const
{
    return r_.step_reductions < kMostReductions && (r_.outcome == ShakeOutcome::not_finite ||
                                                    r_.outcome == ShakeOutcome::energy_astray);
}

/// Starts again from the wall at rest with half the step.
void HistoryRun::start_again()
{
    fraction_ *= 0.5;
    ShakeResult fresh;
    fresh.step_reductions = r_.step_reductions + 1;
    r_ = std::move(fresh);
    open_.clear();
    further_ = false;
    top_x_ = next_point_ = next_snapshot_ = 0.0;
}

template <class Real> ShakeResult HistoryRun::finish(const ShakenWalls<Real>& walls, int lane)
{
    const bool fell = r_.outcome == ShakeOutcome::collapsed;
    r_.end = clock_.time();
    r_.steps = clock_.step;
    r_.seconds = seconds_;
    if (r_.outcome == ShakeOutcome::not_finite) return std::move(r_);
    top_u_ = displacement(walls.state, lane);
    r_.residual_displacement = free_.any() && !r_.still ? free_.mean() : top_u_;
    r_.ground_work = dem::lane(walls.ground_work, lane);
    r_.fall_work = dem::lane(walls.fall_work, lane);
    r_.overturned = fell && overturned(task_->model.layout, masses_, walls.state.finite, lane);
    r_.at_end = snapshot(walls.state, lane);
    // A wall that fell never turned back.
    if (r_.at_most.blocks.empty() || fell) r_.at_most = r_.at_end;
    return std::move(r_);
}

template bool HistoryRun::load(ShakenWalls<double>&, int);
template bool HistoryRun::look(ShakenWalls<double>&, int);
template ShakeResult HistoryRun::finish(const ShakenWalls<double>&, int);
template bool HistoryRun::load(ShakenWalls<Pack>&, int);
template bool HistoryRun::look(ShakenWalls<Pack>&, int);
template ShakeResult HistoryRun::finish(const ShakenWalls<Pack>&, int);

} // namespace dem
