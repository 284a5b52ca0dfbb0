#include "dem/shaking/shake.hpp"

#include "dem/block/model.hpp"
#include "dem/shaking/shaking_step.hpp"
#include "dem/solver/finite_step.hpp"
#include "dem/solver/push.hpp"
#include "dem/solver/static_start.hpp"
#include "dem/solver/step.hpp"
#include "dem/solver/take_snapshot.hpp"
#include "dem/solver/vertical_load.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace dem {

namespace {

constexpr double kBalance = 1e-6; // [-] of the static start
constexpr long long kMostStartSteps = 60'000;
constexpr double kLedger = 0.01; // [-] error of the energy balance that is borne
constexpr double kLeastPassed =
    1e-4; // energy that the balance is a share of, over load times height
constexpr double kContactShare =
    0.2; // of a contact's own limit, at which one that opens and closes keeps its energy
constexpr double kDampedFraction =
    0.7; // of the stable step, with dashpots: k + 2 d <= 4 in units of the step
constexpr int kMostReductions = 6;
constexpr double kStill = 1e-8; // kinetic energy over the largest so far
constexpr long long kLookEvery = 50;
constexpr double kResidualShare =
    0.2; // of the free vibration, over which the residual is a mean

void require(bool ok, const char* what)
{
    if (!ok) throw std::invalid_argument(what);
}

void check_plan(const ShakePlan& p)
{
    const auto finite = [](const std::vector<double>& a) {
        return std::ranges::all_of(a, [](double x) { return std::isfinite(x); });
    };
    require(p.step > 0 && std::isfinite(p.step), "time between samples must be positive");
    require(finite(p.horizontal) && finite(p.vertical),
            "accelerations of the ground must be finite");
    require(
        p.vertical.empty() || p.vertical.size() == p.horizontal.size(),
        "the vertical motion of the ground must have as many samples as the horizontal one");
    require(p.free_vibration >= 0, "the time of free vibration must not be negative");
    require(p.record_every > 0, "the time between points of the history must be positive");
    require(p.contact_damping >= 0, "contact damping must not be negative");
    require(p.step_fraction > 0 && p.step_fraction <= 1,
            "the step must be above 0 and at most the largest stable one");
}

void check_model(const Model& m)
{
    require(
        m.loads.pattern == LoadPattern::body,
        "a wall that is shaken has a beam that moves freely: its loads must be body forces");
    require(m.layout.closure == Closure::linear,
            "joints that close under pressure cannot be shaken yet: closure must be linear");
    require(
        !m.layout.crushing,
        "joints and units that crush cannot be shaken yet: leave the compressive strength out");
}

/// The point of the wall whose displacement is told: the middle of the beam, or of the top
/// course.
struct Top {
    std::vector<int> blocks;
    double x = 0.0, height = 0.0;
};

Top top_of(const Model& m)
{
    Top top;
    const int n = static_cast<int>(m.layout.blocks.size());
    if (m.layout.beam < n) {
        top.blocks = {m.layout.beam};
    } else {
        double highest = 0.0;
        for (const Block& b : m.layout.blocks) highest = std::max(highest, b.z1);
        for (int b = 0; b < n; ++b)
            if (m.layout.blocks[b].z1 > highest - kTouching) top.blocks.push_back(b);
    }
    return top;
}

class History {
  public:
    History(const Model& m, const StepTables& t, const WallMaterials& w, const ShakePlan& p,
            const SolverOptions& o, double fraction);
    ShakeResult run();

  private:
    bool start();
    void release();
    [[nodiscard]] GroundAcceleration ground(long long step) const;
    [[nodiscard]] double displacement() const;
    [[nodiscard]] Energy energy() const;
    void look();
    void keep(double time);
    void finish();
    [[nodiscard]] bool collapsed() const;

    const Model& m_;
    const StepTables& t_;
    const WallMaterials& w_;
    const ShakePlan& plan_;
    SolverOptions options_;
    std::vector<BlockMass> masses_;
    StepLimits limits_;
    WallState<double> s_;
    ShakenBlocks blocks_;
    Top top_;
    ShakeResult r_;
    long long substeps_ = 1, step_ = 0, last_ = 0, record_steps_ = 0, residual_from_ = 0;
    double dt_ = 0.0, passed_ = 0.0, most_missing_ = 0.0, stored_ = 0.0, most_kinetic_ = 0.0,
           load_ = 0.0;
    double residual_sum_ = 0.0;
    double raised_ =
        0.0; ///< energy of blocks that are let go, above their undeformed place [J]
    std::vector<bool> open_;
};

History::History(const Model& m, const StepTables& t, const WallMaterials& w,
                 const ShakePlan& p, const SolverOptions& o, double fraction)
    : m_(m), t_(t), w_(w), plan_(p), options_(o),
      masses_(true_masses(m, t, w, p.load, p.load_height)),
      limits_(step_limits(m, t, w, masses_)), top_(top_of(m)), load_(vertical_load(m, w))
{
    options_.kinematics = Kinematics::finite;
    options_.step_fraction = fraction;
    if (p.contact_damping > 0.0) options_.step_fraction = std::min(fraction, kDampedFraction);
    double most = options_.step_fraction * limits_.all;
    if (p.contact_damping == 0.0)
        most = std::min(most, fraction / p.step_fraction * kContactShare * limits_.contact);
    substeps_ = static_cast<long long>(std::ceil(p.step / most));
    dt_ = p.step / static_cast<double>(substeps_);
    record_steps_ =
        p.horizontal.empty() ? 0 : static_cast<long long>(p.horizontal.size() - 1) * substeps_;
    const auto after = static_cast<long long>(std::llround(p.free_vibration / dt_));
    last_ = record_steps_ + after;
    residual_from_ =
        last_ - static_cast<long long>(kResidualShare * static_cast<double>(after));
    r_.time_step = dt_;
}

/// The wall at rest under its loads, by the static solution and a few damped steps with
/// fictitious masses.
bool History::start()
{
    SolverOptions small = options_;
    small.kinematics = Kinematics::finite;
    s_ = unloaded<double>(m_, t_, {&w_, 1}, small);
    if (!plan_.released.empty()) {
        release();
        return true;
    }
    if (!solve_preload(t_, s_)) return false;
    take_up_frames(t_, options_, s_);
    for (long long i = 0; i < kMostStartSteps; ++i) {
        step(t_, options_, StepInput<double>{}, s_);
        if (i % kLookEvery != kLookEvery - 1) continue;
        r_.unbalance = unbalanced_ratio(s_, 0);
        if (!(r_.unbalance > kBalance)) break;
    }
    return r_.unbalance <= kBalance;
}

void History::release()
{
    for (const Displaced& d : plan_.released) {
        BlockFrame<double>& f = s_.finite.frames[d.block];
        f.x += d.x;
        f.z += d.z;
        f.turn = d.turn;
        f.half = half_turn(f.turn);
    }
    advance_contacts(t_, options_, s_);
    for (std::size_t b = 0; b < masses_.size(); ++b) {
        const BlockFrame<double>& f = s_.finite.frames[b];
        const FiniteTables::BlockRow& row = t_.finite.blocks[b];
        const Turn<double> turn = whole(f.half);
        const double rise =
            f.z + row.centre_z * turn.c - row.centre_x * turn.s - (row.z + row.centre_z);
        raised_ += s_.finite.weight[b] * rise;
    }
}

GroundAcceleration History::ground(long long step) const
{
    const auto at = static_cast<std::size_t>(step / substeps_);
    const double part = static_cast<double>(step % substeps_) / static_cast<double>(substeps_);
    const auto of = [&](const std::vector<double>& a) {
        if (at >= a.size()) return 0.0;
        return at + 1 < a.size() ? a[at] + part * (a[at + 1] - a[at])
                                 : (part == 0.0 ? a[at] : 0.0);
    };
    return {of(plan_.horizontal), of(plan_.vertical)};
}

double History::displacement() const
{
    double sum = 0.0;
    for (const int b : top_.blocks) sum += s_.finite.frames[b].x;
    return sum / static_cast<double>(top_.blocks.size()) - top_.x;
}

Energy History::energy() const
{
    Energy e = energy_of(t_, s_, 0);
    e.kinetic += kinetic_energy(blocks_);
    return e;
}

bool History::collapsed() const
{
    if (blocks_.fall_work - raised_ > kCameDown * m_.layout.height * load_) return true;
    for (const double u : s_.u_n)
        if (u > m_.layout.height) return true;
    return false;
}

void History::keep(double time)
{
    r_.snapshots.push_back(take_snapshot(m_, t_, s_, 0, displacement(), s_.base_shear));
    r_.snapshot_times.push_back(time);
}

/// Energy balance and openings, now and then.
void History::look()
{
    const Energy e = energy();
    const double found = e.kinetic + e.elastic + e.friction + e.fracture + e.damping;
    passed_ = std::max({passed_, std::abs(e.work - stored_), std::abs(found - stored_),
                        std::abs(blocks_.ground_work), std::abs(blocks_.fall_work)});
    const double missing = std::abs(e.work - found);
    if (!std::isfinite(missing)) {
        r_.outcome = ShakeOutcome::not_finite;
        return;
    }
    r_.energy = e;
    most_missing_ = std::max(most_missing_, missing);
    r_.residual = most_missing_ / std::max(passed_, kLeastPassed * m_.layout.height * load_);
    most_kinetic_ = std::max(most_kinetic_, e.kinetic);
    r_.still = e.kinetic <= kStill * most_kinetic_;
    for (std::size_t k = 0; k < open_.size(); ++k)
        if (open_[k] != (s_.u_n[k] > 0.0)) {
            open_[k] = s_.u_n[k] > 0.0;
            r_.last_opening = static_cast<double>(step_) * dt_;
            if (r_.first_opening == 0.0) r_.first_opening = r_.last_opening;
        }
}

ShakeResult History::run()
{
    if (!start()) {
        r_.outcome = ShakeOutcome::unsettled;
        r_.at_end = take_snapshot(m_, t_, s_, 0, 0.0, 0.0);
        return r_;
    }
    std::ranges::fill(s_.v, 0.0);
    s_.work = s_.friction = s_.fracture = s_.damping = 0.0;
    stored_ = s_.work = energy_of(t_, s_, 0).elastic;
    blocks_ = shaken_blocks(m_, t_, w_, masses_, dt_, s_);
    add_dashpots(m_, t_, w_, masses_, limits_, plan_.contact_damping, dt_, s_);
    top_.x = 0.0;
    for (const int b : top_.blocks) r_.top_height += s_.finite.frames[b].z;
    r_.top_height /= static_cast<double>(top_.blocks.size());
    if (plan_.released.empty()) {
        top_.x = displacement();
    } else {
        for (const int b : top_.blocks) top_.x += t_.finite.blocks[b].x;
        top_.x /= static_cast<double>(top_.blocks.size());
    }
    for (std::size_t k = 0; k < m_.dry.size(); ++k) open_.push_back(s_.u_n[k] > 0.0);
    for (const double a : plan_.horizontal)
        r_.peak_ground = std::max(r_.peak_ground, std::abs(a));

    double next_point = 0.0, next_snapshot = 0.0;
    bool further = false; ///< the wall was never so far out
    for (; step_ <= last_; ++step_) {
        const double time = static_cast<double>(step_) * dt_;
        const GroundAcceleration a = ground(step_);
        const double u = displacement();
        if (step_ == 0 || std::abs(u) > r_.most_displacement) {
            r_.most_displacement = std::abs(u);
            r_.most_at = time;
            further = true;
        } else if (further) { // the wall has just turned back, a step ago
            further = false;
            r_.at_most = take_snapshot(m_, t_, s_, 0, u, s_.base_shear);
        }
        const double slack = 0.5 * dt_;
        if (time >= next_point - slack) {
            r_.history.push_back({time, a.x, u, s_.base_shear});
            next_point += plan_.record_every;
        }
        if (plan_.snapshot_every > 0.0 && time >= next_snapshot - slack) {
            keep(time);
            next_snapshot += plan_.snapshot_every;
        }
        if (step_ >= residual_from_) residual_sum_ += u;
        if (step_ == last_) break;
        shaking_step(t_, options_, a, step_ == 0 ? 0.5 : 1.0, blocks_, s_);
        if (step_ % kLookEvery != 0) continue;
        look();
        if (r_.outcome != ShakeOutcome::stood || r_.residual > kLedger) break;
        if (plan_.progress && step_ % (100 * kLookEvery) == 0)
            plan_.progress(static_cast<double>(step_) / static_cast<double>(last_), u);
        if (collapsed()) {
            r_.outcome = ShakeOutcome::collapsed;
            r_.collapse_time = time;
            break;
        }
        if (step_ > record_steps_ && r_.still) break;
    }
    finish();
    return r_;
}

void History::finish()
{
    r_.end = static_cast<double>(step_) * dt_;
    r_.steps = step_;
    if (r_.outcome == ShakeOutcome::not_finite) return;
    if (r_.residual > kLedger) r_.outcome = ShakeOutcome::energy_astray;
    const long long counted = step_ - residual_from_ + 1;
    r_.residual_displacement = counted > 0 && !r_.still
                                   ? residual_sum_ / static_cast<double>(counted)
                                   : displacement();
    r_.ground_work = blocks_.ground_work;
    r_.fall_work = blocks_.fall_work;
    double turned = 0.0, weight = 0.0;
    for (std::size_t b = 0; b < masses_.size(); ++b) {
        weight += masses_[b].mass;
        turned += masses_[b].mass * s_.finite.frames[b].turn;
    }
    r_.overturned = r_.outcome == ShakeOutcome::collapsed && weight > 0.0 &&
                    std::abs(turned / weight) > std::atan2(m_.layout.length, m_.layout.height);
    r_.at_end = take_snapshot(m_, t_, s_, 0, displacement(), s_.base_shear);
    // A wall that fell never turned back.
    if (r_.at_most.blocks.empty() || r_.outcome == ShakeOutcome::collapsed)
        r_.at_most = r_.at_end;
}

} // namespace

std::string_view name_of(ShakeOutcome outcome)
{
    switch (outcome) {
    case ShakeOutcome::stood:
        return "stood";
    case ShakeOutcome::collapsed:
        return "collapsed";
    case ShakeOutcome::unsettled:
        return "unsettled";
    case ShakeOutcome::not_finite:
        return "not finite";
    case ShakeOutcome::energy_astray:
        return "energy astray";
    }
    __builtin_unreachable();
}

ShakeResult shake(const Model& model, const WallMaterials& materials, const ShakePlan& plan,
                  const SolverOptions& options)
{
    check(model, materials);
    check_plan(plan);
    check_model(model);
    const StepTables tables = step_tables(model);
    double fraction = plan.step_fraction;
    for (int reductions = 0;; ++reductions, fraction *= 0.5) {
        History history(model, tables, materials, plan, options, fraction);
        ShakeResult r = history.run();
        r.step_reductions = reductions;
        const bool too_large =
            r.outcome == ShakeOutcome::not_finite || r.outcome == ShakeOutcome::energy_astray;
        if (!too_large || reductions == kMostReductions) return r;
    }
}

} // namespace dem
