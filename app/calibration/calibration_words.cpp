#include "app/calibration/calibration_output.hpp"
#include "app/output/table/cells.hpp"
#include "app/study/stored/stress_text.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

DrawsSummary prior_of(const CalibratedInput& in)
{
    const auto at = [&](double p) { return in.scale * uq::quantile(in.marginal, p); };
    constexpr double kTail = 0.5 * (1.0 - kTableShare);
    return {at(0.5), {at(kTail), at(1.0 - kTail), kTableShare}};
}

DrawsSummary posterior_of(const CalibrationReport& r, const Taught& t, Eigen::Index input)
{
    std::vector<double> values;
    for (const uq::CalibrationPoint& at : t.points)
        values.push_back(r.inputs->inputs[static_cast<std::size_t>(input)].scale *
                         to_values(*r.inputs, at.z)(input));
    return summary_of(values);
}

} // namespace

InputChange input_change(const CalibrationReport& r, std::size_t input)
{
    const auto i = static_cast<Eigen::Index>(input);
    InputChange c{prior_of(r.inputs->inputs[input]),
                  posterior_of(r, r.run->with, i),
                  posterior_of(r, r.run->without, i),
                  {}};
    c.asked = r.study->calibration.discrepancy ? c.with : c.without;
    std::vector<double> scores;
    for (const uq::CalibrationPoint& at : answer_of((*r.study).calibration, *r.run).points)
        scores.push_back((r.inputs->factor * at.z)(i));
    c.moved = summary_of(scores).median;
    c.width_left = (c.asked.interval.upper - c.asked.interval.lower) /
                   (c.prior.interval.upper - c.prior.interval.lower);
    return c;
}

std::string with_unit(std::string_view name, std::string_view unit)
{
    return std::string(name) + (unit.empty() ? "" : " [" + std::string(unit) + "]");
}

std::string answer_text(const CalibrationReport& r)
{
    // of the prior's width, and in its standard deviations; choice
    constexpr double kNarrowed = 0.9, kMoved = 0.25;
    std::string learned, nothing;
    for (std::size_t i = 0; i < r.inputs->inputs.size(); ++i) {
        const CalibratedInput& in = r.inputs->inputs[i];
        const InputChange c = input_change(r, i);
        if (!(c.width_left < kNarrowed || std::abs(c.moved) > kMoved)) {
            nothing += (nothing.empty() ? "" : ", ") + in.key;
            continue;
        }
        const int decimals = std::max(1, decimals_for(c.asked.median));
        const auto text = [&](double x) { return fixed(x, decimals); };
        learned += (learned.empty() ? "" : "; ") + in.key + " " + text(c.prior.median) +
                   " before, " + text(c.asked.median) + " [" + text(c.asked.interval.lower) +
                   ", " + text(c.asked.interval.upper) + "]" +
                   (in.unit.empty() ? "" : " " + in.unit);
    }
    std::string text = "The answer: what " +
                       counted(r.data->tests.size(), "measured value", "measured values") +
                       (r.data->tests.size() == 1 ? " teaches: " : " teach: ") +
                       (learned.empty() ? "next to nothing of any input" : learned) + ".";
    if (!nothing.empty() && !learned.empty())
        text += " Of " + nothing + " they teach next to nothing.";
    return text + "\n";
}

/// Chains beside those of the answer that do not agree; empty: all do.
std::string others_unconverged(const CalibrationReport& r)
{
    const CalibrationRun& run = *r.run;
    const bool other = uq::has_converged(
        (r.study->calibration.discrepancy ? run.without : run.with).posterior);
    std::string without;
    for (std::size_t level = 0; level < run.left_out.size(); ++level)
        if (!run.left_out[level].converged)
            without += (without.empty() ? "" : ", ") +
                       stress_text(r.study->load.vertical_stress[level]);
    std::string text;
    if (!other)
        text += std::string("Not converged: the chains ") +
                (r.study->calibration.discrepancy ? "without" : "with") +
                " discrepancy. Do not compare their evidence.\n";
    if (!without.empty())
        text += "Not converged: what the tests under the other stresses say of " + without +
                ". Do not use \"by other stresses\" there.\n";
    return text;
}

std::string doubt_text(const CalibrationReport& r)
{
    const uq::CalibrationPosterior& p = answer_of((*r.study).calibration, *r.run).posterior;
    std::string text;
    if (!uq::has_converged(p))
        text += "Not converged: the chains do not agree yet (R-hat " + fixed(p.r_hat, 3) +
                ", to be at most " + fixed(uq::kConvergedRHat, 2) + "), or say too little (" +
                fixed(p.effective, 0) + " effective draws, to be " +
                fixed(uq::kConvergedSize, 0) +
                " or more). Do not use these numbers; name fewer "
                "inputs in calibration.inputs.\n";
    else
        text += "The chains agree: R-hat " + fixed(p.r_hat, 3) + ", " + fixed(p.effective, 0) +
                " effective draws.\n";
    text += others_unconverged(r);
    const uq::Evidence a = r.run->with.posterior.evidence,
                       b = r.run->without.posterior.evidence;
    text += "ln of the evidence: " + fixed(a.log_value, 2) + " +- " + fixed(a.std_error, 2) +
            " with discrepancy, " + fixed(b.log_value, 2) + " +- " + fixed(b.std_error, 2) +
            " without. Compare it with that of another law for the same tests: the larger one "
            "is the better bet, by exp(difference) to 1.\n";
    if (r.run->miss.empty())
        text +=
            "Not checked by true walls: the walls of this study are pushed both ways, lie in "
            "several layouts or vary from joint to joint.\n";
    else if (!r.run->first_miss.empty())
        text += "The surrogate missed true walls at points of the posterior by more than " +
                fixed(100.0 * kLargeMiss, 0) +
                " %: they were added to the walls of the study, and the fit was made once "
                "more.\n";
    for (const std::string& remark : r.data->remarks) text += remark + "\n";
    return text;
}

} // namespace app
