#include "dem/solver/wall_run.hpp"

#include "dem/block/model.hpp"
#include "dem/solver/slower.hpp"
#include "dem/solver/solver_error.hpp"
#include "dem/solver/state/take_snapshot.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step/brittle_contacts.hpp"
#include "dem/solver/step/finite_step.hpp"
#include "dem/solver/step/stability_limit.hpp"
#include "dem/solver/step/vertical_load.hpp"
#include "dem/solver/thread_time.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dem {

namespace {

constexpr long long kLookEvery = 500; // steps between looks at the whole wall
constexpr long long kWatchEvery = 50; // steps between them while a wall may be falling
// Share of kinetic in all energy that passed through a wall above which it falls, if it stores
// less. On its way in balance a wall has some 1e-4 of it; the ledger of one that falls breaks
// at 0.2 to 0.5, where blocks strike each other.
constexpr double kFalling = 0.1; // a free choice between the two
// Share of the kinetic energy of a wall that falls that weight and vertical load have given it
// on its way down. What moves because it is pushed has its energy from the drive: on joints as
// stiff as stone that is more than they store.
constexpr double kOfTheLoad = 0.5; // a free choice: elastic energy may have given the rest
// Way down of all that presses, as a share of the height, before which no wall has fallen,
// however little its joints give.
constexpr double kFallen = 1e-5; // a free choice, less than an ordinary wall settles
// Start of a wall that seems to come down under its vertical load: so many times the steps, and
// kSlowSteps at least. The load grows over a quarter of them. Before kSlowLook nothing is said
// of blocks that are hardly loaded yet. Both are steps of fraction 1.
constexpr double kSlowStart = 10.0, kSlowSteps = 30'000.0, kSlowLook = 2000.0;
// Work that the load still does in the second half of a first start, as a share of the energy
// stored, from which a slow start follows. Standing walls that have not come to rest have 0.02
// or less.
constexpr double kStillGives = 0.05;
// Kinetic energy that no wall with an equilibrium has, as a multiple of the energy that it
// stores with closed joints: where joints open it stores more, and at most that moves it on its
// way there. Soft stones between stiff joints sway slowly.
constexpr double kNeverMore = 2.0; // a free choice
// A wall that misses the accuracy is pushed again so many times slower.
constexpr double kSlowdown = 2.0;
// The peak is past where the force has come down to this share of it, or where it has grown by
// less than this factor while the way has doubled.
// Both are free choices: they move the cost, and the tail of a slower push.
constexpr double kPast = 0.8, kFlat = 1.02;
// Error of the slower of two pushes, as a multiple of the change of its peak: 1, if errors fall
// with the accuracy asked; 2.4, with its root. Both may be wrong by the same: a small change is
// believed down to kBelieved of the estimate of the push itself.
constexpr double kChange = 10.0 / 3.0, kBelieved = 0.5; // free choices (solver_error.cpp)
// Error that no push claims to be below, as a share of the accuracy: a push does not feel at
// its peak what it did before.
constexpr double kLeastError = 0.5;
// Kinetic energy of a wall at rest under its vertical load, as a share of what it stores.
// Forces are in balance, too, in a wall that comes down at a constant speed.
constexpr double kAtRest = 1e-3; // a free choice
// Ratio of the ways at which a wall is looked at, so that about half of the way is known
// wherever it ends.
constexpr double kTrail = 1.1;
// A way that is a sum of steps may miss a mark by this share of it.
constexpr double kWayRounding = 1e-9;
constexpr double kMeasuredLimit =
    0.99; // largest share of the measured limit, which is known to 1e-3
constexpr double kSmallestStep = 1.0 / 64.0; // smallest step, as a share of the proven limit

/// Mean settlement of the beam's lower face [m].
double settlement_of(const Snapshot& s)
{
    double sum = 0.0;
    int n = 0;
    const BlockState& beam = s.blocks.back();
    for (std::size_t p = 0; p < beam.outline.size(); ++p)
        if (std::abs(beam.outline[p].z - beam.outline.front().z) < 1e-9) {
            sum -= beam.displacement[p].z;
            ++n;
        }
    return sum / n;
}

/// How far blocks that were in contact are apart, have sunk through a joint that is crushed, or
/// have passed through each other [m].
template <class Real> double farthest_apart(const WallState<Real>& s, int lane)
{
    double worst = 0.0;
    for (const Real& u_n : s.u_n) worst = std::max(worst, dem::lane(u_n, lane));
    for (const Real& crushed : s.crushed) worst = std::max(worst, dem::lane(crushed, lane));
    for (const auto& pair : s.finite.pairs)
        if (dem::lane(pair.share, lane) == 0.0)
            worst = std::max(worst, -dem::lane(pair.gap, lane));
    return worst;
}

} // namespace

WallRun::WallRun(const Task& task, std::size_t number, WallMaterials materials)
    : task_(&task), number_(number), materials_(std::move(materials)), options_(task.options),
      fall_work_(kFallen * task.model.layout.height * vertical_load(task.model, materials_)),
      drive_(task.plan.targets, options_), recorder_(task.plan.record_every, options_.accuracy)
{
    result_.snap_back_contacts = snap_back_contacts(task.model, materials_);
    result_.shear_snap_back_contacts = shear_snap_back_contacts(task.model, materials_);
    result_.crack_contacts = static_cast<int>(task.model.cracks.size());
    result_.brittle_crushing_contacts = brittle_crushing_contacts(task.model, materials_);
}

/// This wall alone, unloaded, with a step that is stable as long as nothing opens, slips or
/// cracks. Up to a step fraction of 1 this is proven. Above 1 the limit is measured, because
/// the energy balance does not find every step that is too large: it misses a joint that
/// chatters a little while it slides (bench/stability: 16 of 2400 walls). Where joints close
/// nothing is measured: their stiffness is yet to come.
WallState<double> WallRun::with_stable_step()
{
    for (;;) {
        WallState<double> wall =
            unloaded<double>(task_->model, task_->tables, {&materials_, 1}, options_);
        const bool measured = task_->model.layout.closure == Closure::linear;
        if (options_.step_fraction <= 1.0 ||
            (measured && step_over_limit(task_->tables, wall, options_) < kMeasuredLimit))
            return wall;
        reduce_step();
    }
}

template <class Real> void WallRun::load(WallState<Real>& state, int lane)
{
    WallState<double> wall = with_stable_step();
    load_lane(task_->model, task_->tables, materials_, options_, lane, state);
    if (options_.preload != Preload::ramped) {
        if (solve_preload(task_->tables, wall)) {
            solved_energy_ = wall.work;
        } else {
            options_.preload = Preload::ramped;
            drive_ = Drive(task_->plan.targets, options_);
        }
    }
    WallState<double> pressed = wall;
    elastic_ = elastic_push(task_->tables, pressed);
    if (options_.kinematics == Kinematics::finite)
        take_up_frames(task_->tables, options_, wall);
    else if (options_.preload == Preload::ramped)
        return;
    copy_to_lane(wall, lane, state);
}

WallRun::Input WallRun::next(double top_force)
{
    load_factor_ = drive_.load_factor();
    force_before_ = top_force;
    step_drive_ = drive_.advance();
    return {load_factor_, step_drive_, drive_.settling() ? 0.0 : 1.0};
}

template <class Real> void WallRun::begin_push(const WallState<Real>& state, int lane)
{
    const Energy e = energy_of(task_->tables, state, lane);
    work_before_push_ = e.work;
    result_.residual = std::max(result_.residual, std::abs(e.residual()));
    const double force = dem::lane(state.top_force, lane);
    result_.curve.push_back({0.0, force, dem::lane(state.base_shear, lane), 0.0, e});
    recorder_.begin_way(drive_.turns_back() ? Recorder::kAfterTurn : Recorder::kAtStart);
    result_.settled = drive_.settled();
    Snapshot s = take_snapshot(task_->model, task_->tables, state, lane, 0.0, force);
    result_.settlement = settlement_of(s);
    if (task_->plan.snapshot_at_peak) result_.at_peak = s;
    if (task_->plan.snapshot_every > 0.0) keep(std::move(s));
    next_snapshot_ = task_->plan.snapshot_every;
}

/// All blocks begin with the velocities that they have in a wall in which nothing opens, slips
/// or cracks: no wave has to pass through it first. The energy for that comes from the drive.
template <class Real> void WallRun::set_moving(WallState<Real>& state, int lane)
{
    const double speed = drive_.begin({.stiffness = elastic_.stiffness,
                                       .mass = elastic_.mass,
                                       .most_force = sideways_force(task_->model, materials_),
                                       .damping = dem::lane(state.damping, lane)});
    const double before = energy_of(task_->tables, state, lane).kinetic;
    for (std::size_t m = 0; m < elastic_.rate.size(); ++m)
        set_lane(state.v[m], lane, dem::lane(state.v[m], lane) + speed * elastic_.rate[m]);
    const double given = energy_of(task_->tables, state, lane).kinetic - before;
    set_lane(state.work, lane, dem::lane(state.work, lane) + given);
    drive_work_ += given;
    elastic_.rate = {};
    motion_ = {};
}

template <class Real> Energy WallRun::energy(const WallState<Real>& state, int lane) const
{
    Energy e = energy_of(task_->tables, state, lane);
    if (!drive_.settling()) e.lifted = drive_work_ - (e.work - work_before_push_);
    return e;
}

/// Time spent in the sink is not charged to the solver.
void WallRun::keep(Snapshot&& snapshot)
{
    const SnapshotSink& sink = task_->plan.sink;
    if (!sink.take) {
        result_.snapshots.push_back(std::move(snapshot));
        return;
    }
    const double before = thread_seconds();
    sink.take(number_, std::move(snapshot));
    spend(before - thread_seconds());
}

/// Means over intervals do not reach the turn, nor the end of a push that turns back. The last
/// parts of the last interval tell the point there, or the last two points of this way where it
/// has too few steps; the forces of the moment itself ring with the drive that stops.
template <class Real> void WallRun::take_turn(const WallState<Real>& state, int lane)
{
    const CurvePoint last = result_.curve.back(),
                     before = result_.curve[result_.curve.size() - 2];
    CurvePoint p = last;
    p.displacement = drive_.position();
    const double along = p.displacement - last.displacement,
                 way = last.displacement - before.displacement;
    if (const auto at_end = recorder_.at_end()) {
        p.force = 0.5 * (at_end->force + at_end->base);
        p.base_shear = at_end->base;
    } else if (along * way > 0.0) {
        p.force += (last.force - before.force) * along / way;
        p.base_shear += (last.base_shear - before.base_shear) * along / way;
    }
    result_.curve.push_back(p);
    if (std::abs(p.displacement) < farthest_) return;
    farthest_ = std::abs(p.displacement);
    result_.at_farthest =
        take_snapshot(task_->model, task_->tables, state, lane, p.displacement, p.force);
}

template <class Take> void WallRun::keep_trail(Take take)
{
    const double way = std::abs(drive_.position());
    if (!trail_.empty() && way < kTrail * std::abs(trail_.back().displacement)) return;
    trail_.push_back(take());
    while (trail_.size() > 1 && std::abs(trail_[1].displacement) <= 0.5 * way)
        trail_.pop_front();
}

template <class Real> void WallRun::take_point(const WallState<Real>& state, int lane)
{
    const Energy e = energy(state, lane);
    result_.residual = std::max(result_.residual, std::abs(e.residual()));
    CurvePoint p = recorder_.take(drive_.position(), e);
    if (task_->plan.mean_stresses) means_.end_interval();
    if (task_->tables.body_forces)
        p.corner =
            corner_displacement(task_->model, task_->tables, state, lane, drive_.position());
    result_.curve.push_back(p);
    const auto snapshot = [&] {
        return take_snapshot(task_->model, task_->tables, state, lane, drive_.position(),
                             p.force);
    };
    if (std::abs(p.force) > peak_) {
        peak_ = std::abs(p.force);
        resists_ = p.force * drive_.position() > 0.0;
        result_.at_drop.reset();
        if (task_->plan.snapshot_at_peak) result_.at_peak = snapshot();
        result_.faces_at_peak =
            take_faces(task_->model, task_->tables, state, lane, drive_.position(), p.force);
    }
    if (task_->plan.drop > 0.0 && !result_.at_drop &&
        std::abs(p.force) <= task_->plan.drop * peak_)
        result_.at_drop = snapshot();
    if (task_->plan.drop > 0.0) keep_trail(snapshot);
    if (task_->plan.snapshot_every > 0.0 && way_ >= next_snapshot_ * (1.0 - kWayRounding)) {
        Snapshot s = snapshot();
        if (task_->plan.mean_stresses) means_.give_to(s, task_->model, recorder_.joined());
        keep(std::move(s));
        next_snapshot_ += task_->plan.snapshot_every;
    }
    decided_ = task_->plan.decided && task_->plan.decided(result_.curve);
    if (before_ && way_ <= before_->way * (1.0 + kWayRounding)) peak_then_ = peak_;
    peak_known_ = passed_peak();
    keep_pace();
}

/// A step counts the work of the load that it began with. If the load has grown by the end of
/// the step, half of the growth has acted as well. Without that, the energy balance would miss
/// about one part in the number of steps of the ramp.
template <class Real> void WallRun::add_ramp_work(WallState<Real>& state, int lane) const
{
    const double growth = drive_.load_factor() - load_factor_;
    if (growth == 0.0) return;
    double work = 0.0;
    for (std::size_t i = 0; i < state.v.size(); ++i)
        work += dem::lane(state.laws.load[i], lane) * dem::lane(state.v[i], lane);
    set_lane(state.work, lane, dem::lane(state.work, lane) + 0.5 * growth * work);
}

/// After a step under vertical load alone. A wall that is not at rest when the steps for it are
/// spent seems to come down where more energy moves it than it stores, or where the load goes
/// on doing work. A slow start follows (look), and tells.
template <class Real> void WallRun::settle(WallState<Real>& state, int lane)
{
    add_ramp_work(state, lane);
    drive_.settle([&] {
        if (!(unbalanced_ratio(state, lane) < options_.preload_unbalance)) return false;
        const Energy e = energy(state, lane);
        return e.kinetic <= kAtRest * e.elastic;
    });
    if (steps_ == options_.preload_steps / 2) work_half_way_ = energy(state, lane).work;
    const bool slow = result_.slow_starts > 0;
    const double steps = static_cast<double>(steps_) * std::min(1.0, options_.step_fraction);
    const bool due = slow && steps >= kSlowLook && steps_ % kLookEvery == 0;
    if (drive_.settling() && !due) return;
    const Energy e = energy(state, lane);
    const double closed = slow ? load_factor_ * load_factor_ * solved_energy_ : 0.0;
    const double most = std::max(e.elastic, kNeverMore * closed);
    const bool moves = e.kinetic > most;
    if (drive_.settling() && !moves) return;
    begin_push(state, lane);
    const double given = e.work - work_half_way_;
    came_down_ = !result_.settled && (moves || given > (slow ? 1.0 : kStillGives) * most);
    if (!came_down_) set_moving(state, lane);
}

bool WallRun::falls(const Energy& e)
{
    const double given = e.work - work_before_push_ - drive_work_;
    least_given_ = std::min(least_given_, given);
    return e.kinetic > std::max(e.elastic, kFalling * e.passed()) &&
           given - least_given_ > std::max(kOfTheLoad * e.kinetic, fall_work_);
}

/// After a step of the push. Takes a point of the curve if one is due.
template <class Real> void WallRun::go_on(const WallState<Real>& state, int lane)
{
    const double top = dem::lane(state.top_force, lane),
                 base = dem::lane(state.base_shear, lane);
    way_ += std::abs(step_drive_);
    drive_work_ += 0.5 * (force_before_ + top) * step_drive_;
    recorder_.add(step_drive_, force_before_, top, base - dem::lane(state.load_x, lane));
    if (task_->plan.mean_stresses) means_.add(state, lane, std::abs(step_drive_));
    const double missing = top + dem::lane(state.load_x, lane) - base;
    Pace& pace = drive_.pace();
    if (pace.samples()) motion_.add(state, lane);
    const Kinetic kinetic = pace.ends_window() ? motion_.take() : Kinetic{};
    pace.feel({std::abs(step_drive_), top, std::abs(missing), dem::lane(state.damping, lane),
               dem::lane(state.fracture, lane)},
              kinetic);
    const bool room_for_another = drive_.left_to_mark() > 0.5 * task_->plan.record_every;
    const bool wanted = drive_.finished() || drive_.turned() || drive_.passed_zero() ||
                        (recorder_.due() && room_for_another);
    if (wanted && recorder_.any()) take_point(state, lane);
    if (!drive_.turned() && !drive_.came_to_its_end()) return;
    take_turn(state, lane);
    recorder_.begin_way();
    means_.begin_way();
}

/// Whether the run can go on. The energy is looked at first, because a wall that too large a
/// step has torn apart has not lost its equilibrium. Its balance is not finite if any number of
/// the wall is not.
template <class Real> Outcome WallRun::judge(const WallState<Real>& state, int lane)
{
    const Energy e = energy(state, lane);
    const double residual = std::abs(e.residual());
    if (!std::isfinite(residual)) return Outcome::not_finite;
    result_.residual = std::max(result_.residual, residual); // the largest at any point counts
    if (result_.residual > options_.energy_tolerance) return Outcome::energy_astray;
    if (came_down_ || (may_fall() && falls(e))) return Outcome::lost_equilibrium;
    if (farthest_apart(state, lane) > task_->model.layout.height)
        return Outcome::lost_equilibrium;
    if (result_.cost.steps >= options_.most_steps) return Outcome::out_of_steps;
    return Outcome::reached_target;
}

template <class Real> bool WallRun::look(WallState<Real>& state, int lane)
{
    drive_.settling() ? settle(state, lane) : go_on(state, lane);
    const bool over = drive_.finished() || decided_ || came_down_;
    ++result_.cost.steps;
    if (!over && std::exchange(peak_known_, false) && wants_slowdown()) {
        slow_down();
        load(state, lane);
        return true;
    }
    const long long every = may_fall() && drive_.waits() ? kWatchEvery : kLookEvery;
    if (++steps_ % every != 0 && !over) return true;
    result_.outcome = judge(state, lane);
    if (task_->plan.progress)
        task_->plan.progress({number_, drive_.done(), drive_.position(),
                              dem::lane(state.top_force, lane), result_.slow_starts,
                              result_.step_reductions, result_.slowdowns, error_before_});
    const bool too_large =
        result_.outcome == Outcome::not_finite || result_.outcome == Outcome::energy_astray;
    if (too_large && options_.step_fraction > kSmallestStep) {
        reduce_step();
        load(state, lane);
        return true;
    }
    const bool unpushed = way_ == 0.0 && result_.slow_starts == 0;
    if (result_.outcome == Outcome::lost_equilibrium && unpushed) {
        start_slowly();
        load(state, lane);
        return true;
    }
    if ((over || result_.outcome == Outcome::lost_equilibrium) && wants_slowdown()) {
        slow_down();
        load(state, lane);
        return true;
    }
    if (decided_ && result_.outcome == Outcome::reached_target)
        result_.outcome = Outcome::decided;
    return !over && result_.outcome == Outcome::reached_target;
}

/// Starts again from the unloaded wall with half the step, because the step was above the
/// measured limit, made energy, or left a number that is not finite.
void WallRun::reduce_step()
{
    options_.step_fraction *= 0.5;
    options_.steps_per_mm *= 2.0;
    if (result_.slow_starts > 0) options_.preload_steps *= 2;
    ++result_.step_reductions;
    start_again();
}

/// Starts again from the unloaded wall under a load that grows slowly, because blocks that a
/// quick start sets moving may go on to fall where the wall has an equilibrium.
void WallRun::start_slowly()
{
    options_.preload = Preload::ramped;
    const double steps = kSlowStart * static_cast<double>(task_->options.preload_steps);
    options_.preload_steps =
        std::llround(std::max(steps, kSlowSteps) / std::min(1.0, options_.step_fraction));
    ++result_.slow_starts;
    start_again();
}

/// Whether the push has just gone so far that its error at the peak is known. The peak of a
/// push to and fro is known at its end.
bool WallRun::passed_peak()
{
    if (drive_.turns_back()) return false;
    const double held = std::abs(result_.curve.front().force), rise = peak_ - held;
    const bool doubled = way_ >= 2.0 * looked_.way,
               flat = doubled && rise <= kFlat * (looked_.peak - held);
    if (doubled) looked_ = {way_, peak_};
    const bool past = (flat && resists_) || is_past();
    if (!past || peak_ == estimated_) return false;
    estimated_ = peak_;
    return true;
}

/// A force that holds the loaded wall against the push falls at first, and is no peak.
bool WallRun::is_past() const
{
    return resists_ && std::abs(result_.curve.back().force) <= kPast * peak_;
}

/// A slower push is as fast as the first one where its peak is past.
void WallRun::keep_pace()
{
    const bool past = !drive_.turns_back() && is_past();
    if (result_.slowdowns == 0 || past == eased_) return;
    eased_ = past;
    const double slowed = std::pow(kSlowdown, result_.slowdowns);
    drive_.pace().change(past ? slower(options_, 1.0 / slowed) : options_);
}

/// Reads the error of a push whose peak is known. A slower push than another knows how much
/// that has changed over the way of the other.
/// @return whether it misses the accuracy, and pushes are left
bool WallRun::wants_slowdown()
{
    const double asked = task_->options.accuracy;
    const int left = task_->options.most_slowdowns - result_.slowdowns;
    double error = force_error(result_.curve, options_.damping);
    if (before_ && peak_then_ > 0.0) {
        const double change = std::abs(peak_then_ - before_->peak) / peak_then_;
        error = std::min(error, std::max(kChange * change, kBelieved * error));
    }
    result_.solver_error = peak_ > 0.0 ? std::max(error, kLeastError * asked) : 0.0;
    const bool read = result_.outcome == Outcome::reached_target ||
                      result_.outcome == Outcome::lost_equilibrium;
    return read && options_.unbalance_limit > 0.0 && left > 0 && result_.solver_error > asked;
}

void WallRun::slow_down()
{
    options_ = slower(options_, kSlowdown);
    before_ = {way_, peak_};
    error_before_ = result_.solver_error;
    ++result_.slowdowns;
    start_again();
}

void WallRun::start_again()
{
    PushResult fresh;
    fresh.snap_back_contacts = result_.snap_back_contacts;
    fresh.shear_snap_back_contacts = result_.shear_snap_back_contacts;
    fresh.crack_contacts = result_.crack_contacts;
    fresh.brittle_crushing_contacts = result_.brittle_crushing_contacts;
    fresh.step_reductions = result_.step_reductions;
    fresh.slow_starts = result_.slow_starts;
    fresh.slowdowns = result_.slowdowns;
    fresh.cost = result_.cost;
    result_ = std::move(fresh);
    if (task_->plan.sink.take) task_->plan.sink.forget(number_);
    drive_ = Drive(task_->plan.targets, options_);
    recorder_ = Recorder(task_->plan.record_every, options_.accuracy);
    peak_ = peak_then_ = estimated_ = 0.0;
    looked_ = {};
    peak_known_ = eased_ = resists_ = false;
    farthest_ = way_ = next_snapshot_ = drive_work_ = work_before_push_ = 0.0;
    work_half_way_ = least_given_ = 0.0;
    trail_.clear();
    means_ = {};
    steps_ = 0;
    decided_ = came_down_ = false;
}

template <class Real> PushResult WallRun::finish(const WallState<Real>& state, int lane)
{
    PushResult& r = result_;
    r.step_fraction = options_.step_fraction;
    r.energy = energy(state, lane);
    r.at_end = take_snapshot(task_->model, task_->tables, state, lane, drive_.position(),
                             r.curve.empty() ? dem::lane(state.top_force, lane)
                                             : r.curve.back().force);
    if (std::abs(r.at_end.displacement) >= farthest_) r.at_farthest.reset();
    if (!r.at_drop && trail_.size() > 1) r.at_half = std::move(trail_.front());
    r.weight = dem::lane(state.laws.whole_weight, lane);
    r.softened_in_tension = static_cast<int>(dem::lane(state.softened_in_tension, lane));
    r.softened_in_shear = static_cast<int>(dem::lane(state.softened_in_shear, lane));
    r.cost.contact_updates = r.cost.steps * task_->tables.n_contacts;
    return std::move(r);
}

template void WallRun::load(WallState<double>&, int);
template void WallRun::load(WallState<Pack>&, int);
template bool WallRun::look(WallState<double>&, int);
template bool WallRun::look(WallState<Pack>&, int);
template PushResult WallRun::finish(const WallState<double>&, int);
template PushResult WallRun::finish(const WallState<Pack>&, int);

} // namespace dem
