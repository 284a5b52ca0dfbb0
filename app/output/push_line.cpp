#include "app/output/push_line.hpp"

#include "app/text/number_text.hpp"

#include <cmath>
#include <utility>

namespace app {
namespace {

std::string percent(double share) { return number(100.0 * share, 3) + " %"; }

/// Why a push began again between two looks at it; empty where it went on.
std::string why_again(const dem::PushProgress& before, const dem::PushProgress& now,
                      double accuracy)
{
    if (now.slowdowns > before.slowdowns)
        return "pushed again, twice as slowly: the error of the peak force was " +
               percent(now.error_before) + ", asked for: " + percent(accuracy);
    if (now.step_reductions > before.step_reductions)
        return "pushed again with half the time step: the energy balance missed with the "
               "whole one";
    if (now.slow_starts > before.slow_starts)
        return "loaded again, slowly: the wall seemed to come down under its vertical load";
    return {};
}

/// Most pushes end at the drop of their force, far from their last displacement.
ProgressOptions ending_early(ProgressOptions options)
{
    options.ends_early = true;
    return options;
}

int starts(const dem::PushProgress& p)
{
    return 1 + p.slow_starts + p.step_reductions + p.slowdowns;
}

} // namespace

PushLine::PushLine(std::vector<std::string> walls, double accuracy, std::ostream& out,
                   ProgressOptions options, Progress::Clock clock)
    : names_(std::move(walls)), accuracy_(accuracy), work_(names_.size()),
      line_(out, ending_early(options), std::move(clock))
{
}

void PushLine::begin_again(Work& work, const dem::PushProgress& p)
{
    const std::string why = why_again(work.last, p, accuracy_);
    if (why.empty()) return;
    work.before += work.cost * work.done;
    work.cost = std::exp2(p.slowdowns + p.step_reductions);
    line_.remark((names_.size() > 1 ? names_[p.wall] + ": " : "") + why);
}

void PushLine::update(const dem::PushProgress& p)
{
    Work& own = work_[p.wall];
    begin_again(own, p);
    own.done = p.done;
    own.last = p;
    double done = 0.0, all = 0.0;
    for (const Work& w : work_) {
        done += w.before + w.cost * w.done;
        all += w.before + w.cost;
    }
    const double walls = static_cast<double>(work_.size());
    const std::string text =
        fixed(p.force * 1e-3, 1) + " kN at " + fixed(p.displacement * 1e3, 1) + " mm";
    line_.update(done / walls,
                 starts(p) > 1 ? "push " + std::to_string(starts(p)) + ": " + text : text,
                 all / walls);
}

void PushLine::end(std::size_t wall) { work_[wall].done = 1.0; }

void PushLine::finish() { line_.finish(""); }

} // namespace app
