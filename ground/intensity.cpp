#include "ground/intensity.hpp"

#include "ground/call_text.hpp"
#include "ground/motion_facts.hpp"
#include "ground/oscillator.hpp"
#include "ground/record.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace ground {
namespace {

/// Integral of a^2 from the start to each sample, for a step of 1, by the trapezoidal rule.
std::vector<double> energy_growth(const std::vector<double>& a)
{
    std::vector<double> sum(a.size(), 0.0);
    for (std::size_t i = 1; i < a.size(); ++i)
        sum[i] = sum[i - 1] + 0.5 * (a[i - 1] * a[i - 1] + a[i] * a[i]);
    return sum;
}

/// Where a growing line reaches a height [steps].
double reached(const std::vector<double>& line, double height)
{
    const auto at = std::ranges::lower_bound(line, height);
    if (at == line.begin()) return 0.0;
    if (at == line.end()) return static_cast<double>(line.size() - 1);
    const double before = *(at - 1), after = *at;
    return static_cast<double>(at - line.begin() - 1) + (height - before) / (after - before);
}

/// Sum of the three largest local maxima of a line, the sign of which is `sign`.
double three_largest(const std::vector<double>& line, double sign)
{
    std::vector<double> peaks;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double here = sign * line[i];
        const bool rises = i == 0 || sign * line[i - 1] < here;
        const bool falls = i + 1 == line.size() || sign * line[i + 1] <= here;
        if (rises && falls && here > 0.0) peaks.push_back(here);
    }
    std::ranges::sort(peaks, std::greater<>());
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, peaks.size()); ++i) sum += peaks[i];
    return sum;
}

/// The content of the brackets of a measure.
enum class Needs { nothing, period, block };

struct MeasureRow {
    std::string_view name;
    MeasureKind kind;
    Needs needs;
    std::string_view unit;
    double unit_value; ///< in SI
};
constexpr std::array kMeasures = {
    MeasureRow{"pga", MeasureKind::pga, Needs::nothing, "g", kGravity},
    MeasureRow{"pgv", MeasureKind::pgv, Needs::nothing, "m/s", 1.0},
    MeasureRow{"pgd", MeasureKind::pgd, Needs::nothing, "m", 1.0},
    MeasureRow{"sa", MeasureKind::sa, Needs::period, "g", kGravity},
    MeasureRow{"avg_sa", MeasureKind::avg_sa, Needs::period, "g", kGravity},
    MeasureRow{"fiv3", MeasureKind::fiv3, Needs::period, "m/s", 1.0},
    MeasureRow{"cav", MeasureKind::cav, Needs::nothing, "m/s", 1.0},
    MeasureRow{"arias", MeasureKind::arias, Needs::nothing, "m/s", 1.0},
    MeasureRow{"d5_95", MeasureKind::duration, Needs::nothing, "s", 1.0},
    MeasureRow{"rocking_pga", MeasureKind::rocking_pga, Needs::block, "-", 1.0},
    MeasureRow{"rocking_pgv", MeasureKind::rocking_pgv, Needs::block, "-", 1.0},
};

const MeasureRow& row_of(MeasureKind kind)
{
    for (const MeasureRow& row : kMeasures)
        if (row.kind == kind) return row;
    throw std::logic_error("no row of this measure");
}

double tan_alpha(const RockingBlock& block) { return block.half_width / block.half_height; }

/// @throws std::invalid_argument if it is not in [0.01, 20] s
double period_of(const CallText& call)
{
    constexpr double kLeast = 0.01, kMost = 20.0;
    const double period = call.arguments.size() == 1 && (call.arguments[0].name.empty() ||
                                                         call.arguments[0].name == "period")
                              ? quantity(call.arguments[0].value, Dimension::time)
                              : 0.0;
    if (!(period >= kLeast && period <= kMost))
        throw std::invalid_argument(call.name + " needs a period in [0.01, 20] s; write \"" +
                                    call.name + "(0.3 s)\"");
    return period;
}

/// @throws std::invalid_argument if its half width or half height is not in [0.01, 100] m
RockingBlock block_of(const CallText& call)
{
    constexpr double kLeast = 0.01, kMost = 100.0;
    const auto length = [&](std::size_t i, const char* name) {
        if (call.arguments.size() != 2) return 0.0;
        const CallText::Argument& a = call.arguments[i];
        return a.name.empty() || a.name == name ? quantity(a.value, Dimension::length) : 0.0;
    };
    const RockingBlock block{length(0, "half_width"), length(1, "half_height")};
    for (const double x : {block.half_width, block.half_height})
        if (!(x >= kLeast && x <= kMost))
            throw std::invalid_argument(
                call.name +
                " needs half the width and half the height of the block, in [0.01, 100] m; "
                "write \"" +
                call.name + "(0.5 m, 0.6 m)\"");
    return block;
}

} // namespace

double arias_intensity(const GroundMotion& motion)
{
    if (motion.acceleration.empty()) return 0.0;
    return std::numbers::pi / (2.0 * kGravity) * motion.step *
           energy_growth(motion.acceleration).back();
}

double cumulative_absolute_velocity(const GroundMotion& motion)
{
    double sum = 0.0;
    const std::vector<double>& a = motion.acceleration;
    for (std::size_t i = 1; i < a.size(); ++i)
        sum += 0.5 * (std::abs(a[i - 1]) + std::abs(a[i]));
    return motion.step * sum;
}

double significant_duration(const GroundMotion& motion, double from, double to)
{
    const std::vector<double> growth = energy_growth(motion.acceleration);
    if (growth.empty() || growth.back() == 0.0) return 0.0;
    return motion.step *
           (reached(growth, to * growth.back()) - reached(growth, from * growth.back()));
}

double spectral_acceleration(const GroundMotion& motion, double period, double damping)
{
    const double omega = 2.0 * std::numbers::pi / period;
    constexpr double kPerPeriod =
        40.0; // samples: the largest is missed by (pi / 40)^2 / 2 = 0.3 % at most
    const int parts =
        std::clamp(static_cast<int>(std::ceil(motion.step * kPerPeriod / period)), 1, 1000);
    const std::vector<double>& a = motion.acceleration;
    if (parts == 1) return omega * omega * largest_displacement(a, motion.step, omega, damping);
    std::vector<double> fine;
    fine.reserve(a.size() * static_cast<std::size_t>(parts));
    for (std::size_t i = 0; i + 1 < a.size(); ++i)
        for (int k = 0; k < parts; ++k) fine.push_back(a[i] + (a[i + 1] - a[i]) * k / parts);
    fine.push_back(a.back());
    return omega * omega * largest_displacement(fine, motion.step / parts, omega, damping);
}

double average_spectral_acceleration(const GroundMotion& motion, double period)
{
    constexpr int kPeriods = 10;
    constexpr double kFirst = 0.2, kLast = 1.5;
    double sum = 0.0;
    for (int i = 0; i < kPeriods; ++i)
        sum += std::log(spectral_acceleration(
            motion, period * (kFirst + (kLast - kFirst) * i / (kPeriods - 1))));
    return std::exp(sum / kPeriods);
}

double filtered_incremental_velocity(const GroundMotion& motion, double period)
{
    constexpr double kWindow = 0.7, kCutOff = 0.85;
    const GroundMotion passed{"", motion.step,
                              low_passed(motion.acceleration, motion.step, kCutOff / period)};
    const std::vector<double> velocity = integrated(passed).velocity;
    const double window = kWindow * period / motion.step; // [samples]
    const auto velocity_at =
        [&](double t) { // behind the end the filtered acceleration counts as 0
            const double last = static_cast<double>(velocity.size() - 1);
            if (t >= last) return velocity.back();
            const auto i = static_cast<std::size_t>(t);
            return velocity[i] + (velocity[i + 1] - velocity[i]) * (t - static_cast<double>(i));
        };
    std::vector<double> increments(velocity.size());
    for (std::size_t i = 0; i < velocity.size(); ++i)
        increments[i] = velocity_at(static_cast<double>(i) + window) - velocity[i];
    return std::max(three_largest(increments, 1.0), three_largest(increments, -1.0));
}

double rocking_pga(const GroundMotion& motion, const RockingBlock& block)
{
    return motion_facts(motion).pga / (kGravity * tan_alpha(block));
}

double rocking_pgv(const GroundMotion& motion, const RockingBlock& block)
{
    const double radius = std::hypot(block.half_width, block.half_height);
    return motion_facts(motion).pgv * std::sqrt(0.75 * kGravity / radius) /
           (kGravity * tan_alpha(block));
}

Measure parse_measure(std::string_view text)
{
    const CallText call = parse_call(text);
    for (const MeasureRow& row : kMeasures) {
        if (call.name != row.name) continue;
        if (row.needs == Needs::period) return {.kind = row.kind, .period = period_of(call)};
        if (row.needs == Needs::block) return {.kind = row.kind, .block = block_of(call)};
        if (!call.arguments.empty())
            throw std::invalid_argument(call.name + " takes no period; write it alone");
        return {.kind = row.kind};
    }
    throw std::invalid_argument("\"" + call.name +
                                "\" is no measure of intensity; use pga, pgv, pgd, sa(0.3 s), "
                                "avg_sa(0.3 s), fiv3(0.3 s), cav, arias, d5_95, "
                                "rocking_pga(0.5 m, 0.6 m) or rocking_pgv(0.5 m, 0.6 m)");
}

std::string measure_text(const Measure& measure)
{
    const MeasureRow& row = row_of(measure.kind);
    const std::string name(row.name);
    switch (row.needs) {
    case Needs::period:
        return name + "(" + plain_text(measure.period) + " s)";
    case Needs::block:
        return name + "(" + plain_text(measure.block.half_width) + " m, " +
               plain_text(measure.block.half_height) + " m)";
    case Needs::nothing:
        return name;
    }
    throw std::logic_error("no such measure");
}

std::string_view measure_unit(const Measure& measure) { return row_of(measure.kind).unit; }
double measure_unit_value(const Measure& measure) { return row_of(measure.kind).unit_value; }

double intensity(const GroundMotion& motion, const Measure& measure)
{
    switch (measure.kind) {
    case MeasureKind::pga:
        return motion_facts(motion).pga;
    case MeasureKind::pgv:
        return motion_facts(motion).pgv;
    case MeasureKind::pgd:
        return motion_facts(motion).pgd;
    case MeasureKind::sa:
        return spectral_acceleration(motion, measure.period);
    case MeasureKind::avg_sa:
        return average_spectral_acceleration(motion, measure.period);
    case MeasureKind::fiv3:
        return filtered_incremental_velocity(motion, measure.period);
    case MeasureKind::cav:
        return cumulative_absolute_velocity(motion);
    case MeasureKind::arias:
        return arias_intensity(motion);
    case MeasureKind::duration:
        return significant_duration(motion, 0.05, 0.95);
    case MeasureKind::rocking_pga:
        return rocking_pga(motion, measure.block);
    case MeasureKind::rocking_pgv:
        return rocking_pgv(motion, measure.block);
    }
    throw std::logic_error("no such measure");
}

} // namespace ground
