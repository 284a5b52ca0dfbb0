#include "app/calibration/tested_quantity.hpp"

#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "fragility/curve/cyclic_curve.hpp"
#include "fragility/curve/resampled_curve.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// On the capacity curve, which of a push that turns back is its backbone.
double force_at(const TestReading& at, const TestedPath& path, const ReadingRules& rules)
{
    const fragility::Backbone b = capacity_curve({path.displacement, path.force}, rules);
    const std::vector<double> forces =
        fragility::resampled({b.displacement, b.force}, at.displacement, 2);
    return forces.size() == 2 ? forces.back() * kForceUnit.scale : kNoNumber;
}

double energy_of(const TestReading& at, const TestedPath& path, const ReadingRules& rules)
{
    if (rules.direction != 0) return kNoNumber; // the push does not turn back
    const std::vector<fragility::Cycle> all =
        fragility::cycles({path.displacement, path.force});
    const auto place = static_cast<std::size_t>(at.cycle - 1);
    return place < all.size() && all[place].closed ? all[place].energy * kEnergyUnit.scale
                                                   : kNoNumber;
}

TestedQuantity quantity_of(const TestReading& reading, std::size_t place)
{
    TestedQuantity q{};
    q.name = q.words = reading.name;
    const ShownUnit& unit = reading.cycle > 0 ? kEnergyUnit : kForceUnit;
    q.unit = unit.name;
    q.decimals = 1;
    q.reading = place;
    q.at = reading;
    return q;
}

} // namespace

bool is_tested(const std::vector<MeasuredTest>& tests, const TestedQuantity& q)
{
    return std::ranges::any_of(
        tests, [&](const MeasuredTest& t) { return measured(q, t).has_value(); });
}

namespace {

/// Says why a push cannot show a reading; empty: it may.
std::string out_of_reach(const TestReading& r, std::size_t closed, double farthest)
{
    if (r.cycle > 0 && static_cast<std::size_t>(r.cycle) > closed)
        return "the study's push makes " + counted(closed, "closed loop", "closed loops") +
               "; give it the amplitudes of the test, as load.targets";
    if (r.cycle == 0 && r.displacement > farthest)
        return "the study's push goes to " + number(farthest * 1e3, 4) +
               " mm; push farther, with load.max_displacement or load.targets";
    return "";
}

} // namespace

std::string protocol_notes(const Csv& csv, const std::vector<TestReading>& readings,
                           const std::vector<MeasuredTest>& tests,
                           const std::vector<double>& targets)
{
    std::vector<double> path = {0.0};
    double farthest = 0.0;
    for (const double to : targets) {
        if (path.back() * to < 0.0) path.push_back(0.0);
        path.push_back(to);
        farthest = std::max(farthest, std::abs(to));
    }
    const std::vector<double> any_force(path.size(), 0.0);
    const auto closed = static_cast<std::size_t>(std::ranges::count(
        fragility::cycles({path, any_force}), true, &fragility::Cycle::closed));
    std::string notes;
    std::optional<ConfigError> refused;
    bool others = false;
    for (const TestedQuantity& q : tested_quantities(readings)) {
        if (!is_tested(tests, q)) continue;
        const std::string why = q.number != nullptr ? "" : out_of_reach(q.at, closed, farthest);
        others |= why.empty();
        if (why.empty()) continue;
        refused.emplace(csv.path, 1, q.name, why);
        notes += "note: " + std::string(refused->what()) + "; left out\n";
    }
    if (refused && !others) throw ConfigError(*refused);
    return notes;
}

std::vector<TestedQuantity> tested_quantities(const std::vector<TestReading>& readings)
{
    const auto of_number = [](const char* name, const char* words, const WallNumber& number,
                              int decimals, std::optional<double> MeasuredTest::*place,
                              std::string_view factor_key) {
        return TestedQuantity{name,    words,    std::string(number.unit.name),
                              &number, decimals, place,
                              0,       {},       factor_key};
    };
    std::vector<TestedQuantity> all = {
        of_number("peak", "peak force", wall_number("peak_force"), 1, &MeasuredTest::peak,
                  "fragility.model_factor_force"),
        of_number("stiffness", "stiffness", wall_number("secant_stiffness"), 2,
                  &MeasuredTest::stiffness, ""),
        of_number("drop", "displacement at the drop", wall_number("ultimate_displacement"), 1,
                  &MeasuredTest::drop, "fragility.model_factor")};
    for (std::size_t i = 0; i < readings.size(); ++i)
        all.push_back(quantity_of(readings[i], i));
    return all;
}

std::optional<double> measured(const TestedQuantity& q, const MeasuredTest& t)
{
    return q.measured != nullptr ? t.*q.measured : t.readings[q.reading];
}

double shown(const TestedQuantity& q, const TestedPath& path, const ReadingRules& rules)
{
    if (q.number == nullptr)
        return q.at.cycle > 0 ? energy_of(q.at, path, rules) : force_at(q.at, path, rules);
    constexpr double kAnyHeight = 1.0;
    return q.number->unit.scale * q.number->reading(path.wall, kAnyHeight);
}

} // namespace app
