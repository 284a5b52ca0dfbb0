#include "bench/accuracy/accuracy_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bench {

namespace {

bool no_result(const Answer& a) { return a.outcome == kTooDear || a.outcome.empty(); }

bool is_failure(const std::string& outcome)
{
    using dem::Outcome;
    for (const Outcome o :
         {Outcome::not_finite, Outcome::energy_astray, Outcome::out_of_steps, Outcome::no_wall})
        if (outcome == name(o)) return true;
    return false;
}

std::optional<double> relative(const std::optional<double>& x, const std::optional<double>& y)
{
    if (!x || !y || *y == 0.0) return {};
    return *x / *y - 1.0;
}

} // namespace

bool has_reference(const ComparedScene& c)
{
    return c.broken.empty() && !no_result(c.reference) && !is_failure(c.reference.outcome);
}

std::optional<double> peak_error(const ComparedScene& c)
{
    if (!has_reference(c) || is_failure(c.asked.outcome)) return {};
    return relative(c.asked.peak, c.reference.peak);
}

bool is_lost(const ComparedScene& c)
{
    if (!has_reference(c)) return false;
    const bool usable = !no_result(c.asked) && !is_failure(c.asked.outcome);
    return !usable || c.asked.peak.has_value() != c.reference.peak.has_value();
}

std::optional<double> drop_error(const ComparedScene& c)
{
    if (!peak_error(c)) return {};
    return relative(c.asked.drop, c.reference.drop);
}

bool is_branch(const ComparedScene& c)
{
    return peak_error(c) && c.asked.drop.has_value() != c.reference.drop.has_value();
}

bool is_held(const ComparedScene& c)
{
    const double error = std::abs(peak_error(c).value_or(0.0));
    return error < kTooSmall || c.asked.solver_error >= error;
}

bool is_drop_held(const ComparedScene& c)
{
    const Answer& a = c.asked;
    if (!c.reference.drop) return !a.latest;
    const double drop = *c.reference.drop;
    return a.earliest && *a.earliest * (1.0 - kTooSmall) <= drop &&
           (!a.latest || drop <= *a.latest * (1.0 + kTooSmall));
}

double quantile_of(std::vector<double> values, double p)
{
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(values);
    const double rank = std::ceil(p * static_cast<double>(values.size()));
    return values[static_cast<std::size_t>(std::max(1.0, rank)) - 1];
}

std::vector<ComparedScene> as_before(const std::vector<ComparedScene>& scenes)
{
    std::vector<ComparedScene> before;
    for (const ComparedScene& c : scenes) {
        if (!c.before) continue;
        before.push_back(c);
        before.back().asked = *c.before;
    }
    return before;
}

std::string remark_on(const ComparedScene& c)
{
    if (!c.broken.empty()) return c.broken;
    if (no_result(c.reference)) return "reference too dear";
    if (is_failure(c.reference.outcome)) return "reference failed: " + c.reference.outcome;
    if (no_result(c.asked)) return "too dear, but not the reference";
    if (is_failure(c.asked.outcome)) return "failed: " + c.asked.outcome;
    if (is_lost(c))
        return c.asked.peak ? "a peak, but none of the reference: " + c.reference.outcome
                            : "no peak: " + c.asked.outcome;
    if (!c.asked.peak) return "no peak in both: " + c.asked.outcome;
    if (is_branch(c))
        return c.asked.drop ? "falls, reference does not" : "does not fall, reference does";
    if (c.asked.outcome != c.reference.outcome)
        return "ends as " + c.asked.outcome + ", reference as " + c.reference.outcome;
    return "";
}

} // namespace bench
