#include "app/calibration/test_columns.hpp"

#include "app/input/study/units.hpp"
#include "app/text/config_error.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace app {
namespace {

std::span<const std::string_view> units_of(const TestHead& head)
{
    return std::span(head.units).first(head.units.back().empty() ? 1 : 2);
}

/// "peak [kN]"; "drop [mm] or drop [%]" in quotes of their own.
std::string spellings(const TestHead& head)
{
    std::string heads;
    for (const std::string_view unit : units_of(head))
        heads += (heads.empty() ? "\"" : " or \"") + std::string(head.name) + " [" +
                 std::string(unit) + "]\"";
    return heads;
}

/// The column of this name, which has one of its units in brackets and no other.
std::optional<TestColumn> column_of(const Csv& csv, const TestHead& wanted)
{
    for (std::size_t c = 0; c < csv.head.size(); ++c) {
        const std::string& head = csv.head[c];
        if (test_name(head) != wanted.name) continue;
        for (std::size_t other = c + 1; other < csv.head.size(); ++other)
            if (test_name(csv.head[other]) == wanted.name)
                throw ConfigError(csv.path, 1, csv.head[other],
                                  "is a second column of " + in_quotes(wanted.name) +
                                      ", beside " + in_quotes(head) + "; keep one of them");
        const std::size_t bracket = head.find_first_of("[(");
        if (bracket == std::string::npos && wanted.units.front() != "-")
            throw ConfigError(csv.path, 1, head, "missing unit; write " + spellings(wanted));
        if (bracket == std::string::npos) return TestColumn{c, false};
        const std::string_view unit =
            trimmed(std::string_view(head).substr(bracket + 1, head.size() - bracket - 2));
        const auto units = units_of(wanted);
        const auto found = std::ranges::find(units, unit);
        if (found == units.end())
            throw ConfigError(csv.path, 1, head,
                              "is not in " + listed(units) + "; convert it, and write \"" +
                                  std::string(wanted.name) + " [" +
                                  std::string(wanted.units.front()) + "]\"");
        return TestColumn{c, found != units.begin()};
    }
    return {};
}

constexpr std::string_view kForceAt = "force at ", kEnergyOf = "energy of cycle ";

/// Nothing where the column is none of the path.
std::optional<TestReading> reading_of(const std::string& head, double height)
{
    const std::string lower = test_name(head);
    const std::string_view name = lower;
    TestReading r{.name = lower};
    if (name.starts_with(kForceAt)) {
        const std::string_view at = name.substr(kForceAt.size());
        r.displacement =
            at.ends_with('%') ? parse_quantity(at, "%") * height : parse_quantity(at, "mm");
        if (!(r.displacement > 0.0)) throw BadValue("must be at a displacement above 0");
        return r;
    }
    if (!name.starts_with(kEnergyOf)) return {};
    const double cycle = parse_count(name.substr(kEnergyOf.size()));
    constexpr double kMostCycles = 1e6;
    if (!(cycle >= 1.0 && cycle <= kMostCycles)) throw BadValue("cycles count from 1");
    r.cycle = static_cast<int>(cycle);
    return r;
}

/// "force at 2 mm" and "force at 2.0 mm" are one reading.
bool same_place(const TestReading& a, const TestReading& b)
{
    return std::abs(a.displacement - b.displacement) <= 1e-9 * a.displacement;
}

} // namespace

std::string test_name(std::string_view head) { return lower_case(bare_name(head)); }

std::vector<TestReading> test_readings(const Csv& csv, double height)
{
    std::vector<TestReading> all;
    for (const std::string& head : csv.head) try {
            if (std::optional<TestReading> r = reading_of(head, height)) {
                if (std::ranges::any_of(all, [&](const TestReading& o) {
                        return o.cycle == r->cycle && same_place(o, *r);
                    }))
                    throw BadValue("there are two such columns; keep one of them");
                all.push_back(std::move(*r));
            }
        } catch (const BadValue& bad) {
            throw ConfigError(csv.path, 1, head,
                              std::string(bad.what()) +
                                  "; write e.g. \"force at 5 mm [kN]\", \"force at 0.5 % "
                                  "[kN]\" or \"energy of cycle 3 [J]\"");
        }
    return all;
}

TestColumns test_columns(const Csv& csv, double height)
{
    TestColumns c{column_of(csv, kTestStress),
                  column_of(csv, kTestPeak),
                  column_of(csv, kTestStiffness),
                  column_of(csv, kTestDrop),
                  column_of(csv, kTestCensored),
                  column_of(csv, kTestSigma),
                  column_of(csv, kTestWall),
                  test_readings(csv, height),
                  {}};
    for (const TestReading& r : c.readings)
        c.reading_at.push_back(*column_of(csv, r.cycle > 0 ? TestHead{r.name, {"J", "kJ"}}
                                                           : TestHead{r.name, {"kN"}}));
    if (!c.stress)
        throw ConfigError(csv.path, 1, "stress [MPa]",
                          "there is no such column; name the vertical stress of each test");
    if (!c.peak && !c.stiffness && !c.drop && c.readings.empty())
        throw ConfigError(csv.path, 1,
                          "peak [kN], stiffness [kN/mm], drop [mm], force at 5 mm [kN], energy "
                          "of cycle 1 [J]",
                          "there is none of these columns; give at least one of them");
    return c;
}

} // namespace app
