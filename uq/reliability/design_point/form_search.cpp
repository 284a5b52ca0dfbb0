#include "uq/reliability/design_point/form_search.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace uq {

void check(const SearchOptions& o)
{
    const auto require = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("design point search: " + what);
    };
    require(o.step > 0.0 && o.step <= 1.0, "step must be in (0, 1]");
    require(o.on_surface > 0.0 && std::isfinite(o.on_surface), "on_surface must be > 0");
    require(o.on_axis > 0.0 && std::isfinite(o.on_axis), "on_axis must be > 0");
    require(o.max_iterations >= 1, "max_iterations must be at least 1");
}

std::string_view name(SearchMethod m)
{
    switch (m) {
    case SearchMethod::improved_hl_rf:
        return "improved HL-RF";
    case SearchMethod::slsqp:
        return "SLSQP";
    case SearchMethod::cobyla:
        return "COBYLA";
    }
    return "";
}

void give_up(Search& search, SearchOutcome outcome, std::string reason)
{
    search.outcome = outcome;
    search.reason = std::move(reason);
    search.point.reset();
}

void give_up_without_value(Search& search, const Ledger& ledger, const std::string& where)
{
    give_up(search, SearchOutcome::evaluation_failed,
            (ledger.used_up ? "no evaluation was left " : "the model failed ") + where);
}

void judge(const LinearLimit& l, const SearchOptions& o, Search& search)
{
    if (!(l.gradient.norm() > 0.0))
        return give_up(search, SearchOutcome::flat, "the gradient is zero where it stopped");
    const double distance = std::abs(distance_to_plane(l)), off = off_axis(l);
    std::ostringstream where;
    where << "it stopped " << distance << " from the limit state and " << off
          << " off the axis of its gradient [standard deviations], accepted are "
          << o.on_surface << " and " << o.on_axis;
    if (distance > o.on_surface)
        return give_up(search, SearchOutcome::off_surface, where.str());
    if (off > o.on_axis) return give_up(search, SearchOutcome::off_axis, where.str());
    const Eigen::VectorXd alpha = direction(l);
    search.point = DesignPoint{l, alpha, alpha.dot(l.u) + distance_to_plane(l)};
    search.outcome = SearchOutcome::converged;
    search.reason.clear();
}

} // namespace uq
