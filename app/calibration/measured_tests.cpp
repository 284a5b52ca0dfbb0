#include "app/calibration/measured_tests.hpp"

#include "app/fragility/drift_csv.hpp"
#include "app/input/study/units.hpp"
#include "app/study/stored/stress_text.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace app {
namespace {

struct TestColumn {
    std::size_t place;
    bool second_unit; ///< its unit is the second of those allowed
};

/// "peak [kN]"; "drop [mm] or drop [%]" in quotes of their own.
std::string heads_of(std::string_view name, std::initializer_list<std::string_view> units)
{
    std::string heads;
    for (const std::string_view unit : units)
        heads += (heads.empty() ? "\"" : " or \"") + std::string(name) + " [" +
                 std::string(unit) + "]\"";
    return heads;
}

/// The column of this name, which has one of these units in brackets and no other. Where the
/// first of them is none, "-", it may be left out.
std::optional<TestColumn> column_of(const Csv& csv, std::string_view name,
                                    std::initializer_list<std::string_view> units)
{
    for (std::size_t c = 0; c < csv.head.size(); ++c) {
        const std::string& head = csv.head[c];
        if (bare_name(head) != name) continue;
        for (std::size_t other = c + 1; other < csv.head.size(); ++other)
            if (bare_name(csv.head[other]) == name)
                throw ConfigError(csv.path, 1, csv.head[other],
                                  "is a second column of " + in_quotes(name) + ", beside " +
                                      in_quotes(head) + "; keep one of them");
        const std::size_t bracket = head.find_first_of("[(");
        if (bracket == std::string::npos && *units.begin() != "-")
            throw ConfigError(csv.path, 1, head,
                              "missing unit; write " + heads_of(name, units));
        if (bracket == std::string::npos) return TestColumn{c, false};
        const std::string_view unit =
            trimmed(std::string_view(head).substr(bracket + 1, head.size() - bracket - 2));
        const auto found = std::ranges::find(units, unit);
        if (found == units.end())
            throw ConfigError(csv.path, 1, head,
                              "is not in " + listed(units) + "; convert it, and write \"" +
                                  std::string(name) + " [" + std::string(*units.begin()) +
                                  "]\"");
        return TestColumn{c, found != units.begin()};
    }
    return {};
}

/// Values that no test has, in any of the units: they would end in numbers that are not finite.
constexpr double kLeast = 1e-9, kMost = 1e9;

/// Nothing where the cell says that the value is not known.
std::optional<double> positive_at(const Csv& csv, const CsvRow& row,
                                  std::optional<TestColumn> column)
{
    if (!column || is_missing(trimmed(row.cells[column->place]))) return {};
    const double x = number_at(csv, row, column->place);
    if (!(x > 0.0))
        refuse_cell(csv, row, column->place,
                    "must be above 0; write NA if it was not measured");
    if (!(x >= kLeast && x <= kMost))
        refuse_cell(csv, row, column->place, "is no number of a wall; check it and its unit");
    return x;
}

/// "22.7", or "> 22.7" where the test ended before.
void read_drop(const Csv& csv, CsvRow row, std::optional<TestColumn> column, double height,
               MeasuredTest& t)
{
    if (!column) return;
    std::string& cell = row.cells[column->place];
    const std::string_view text = trimmed(cell);
    if (text.starts_with('>')) {
        t.censored = true;
        cell = trimmed(text.substr(text.starts_with(">=") ? 2 : 1));
    }
    t.drop = positive_at(csv, row, column);
    if (t.censored && !t.drop)
        refuse_cell(csv, row, column->place, "a bound without a number; write e.g. \"> 22.7\"");
    constexpr double kMillimetres = 1e3, kPercent = 1e-2;
    if (t.drop && column->second_unit) *t.drop *= kPercent * height * kMillimetres;
}

double error_at(const Csv& csv, const CsvRow& row, std::optional<TestColumn> column)
{
    if (!column || is_missing(trimmed(row.cells[column->place]))) return 0.0;
    const double sigma = number_at(csv, row, column->place);
    const double share = column->second_unit ? sigma / 100.0 : sigma;
    if (!(share >= 0.0 && share <= 1.0))
        refuse_cell(csv, row, column->place,
                    "must be a share of the measured value in [0, 1], or in % under \"sigma "
                    "[%]\"");
    return share;
}

constexpr std::string_view kForceAt = "force at ", kEnergyOf = "energy of cycle ";

/// Nothing where the column is none of the path.
std::optional<TestReading> reading_of(const std::string& head, double height)
{
    const std::string_view name = bare_name(head);
    TestReading r{.name = std::string(name)};
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

/// The columns that a table of tests may have.
struct TestColumns {
    std::optional<TestColumn> stress, peak, stiffness, drop, censored, sigma, wall;
    std::vector<TestReading> readings;
    std::vector<TestColumn> reading_at; ///< of each
};

TestColumns test_columns(const Csv& csv, double height)
{
    TestColumns c{column_of(csv, "stress", {"MPa"}),
                  column_of(csv, "peak", {"kN"}),
                  column_of(csv, "stiffness", {"kN/mm"}),
                  column_of(csv, "drop", {"mm", "%"}),
                  column_of(csv, "censored", {"-"}),
                  column_of(csv, "sigma", {"-", "%"}),
                  column_of(csv, "wall", {"-"}),
                  test_readings(csv, height),
                  {}};
    for (const TestReading& r : c.readings)
        c.reading_at.push_back(r.cycle > 0 ? *column_of(csv, r.name, {"J", "kJ"})
                                           : *column_of(csv, r.name, {"kN"}));
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

/// Values of the readings; energies in J.
std::vector<std::optional<double>> readings_at(const Csv& csv, const CsvRow& row,
                                               const TestColumns& c)
{
    constexpr double kKilo = 1e3;
    std::vector<std::optional<double>> values;
    for (const TestColumn& at : c.reading_at) {
        values.push_back(positive_at(csv, row, at));
        if (values.back() && at.second_unit) *values.back() *= kKilo;
    }
    return values;
}

/// The column of which is said that nothing was measured.
std::size_t first_measured(const TestColumns& c)
{
    for (const std::optional<TestColumn>& at : {c.peak, c.drop, c.stiffness})
        if (at) return at->place;
    return c.reading_at.front().place;
}

} // namespace

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

std::vector<MeasuredTest> measured_tests(const Csv& csv, double height)
{
    check_rows(csv);
    const TestColumns c = test_columns(csv, height);
    std::vector<MeasuredTest> tests;
    for (const CsvRow& row : csv.rows) {
        MeasuredTest t;
        t.line = row.line;
        if (c.wall) t.name = trimmed(row.cells[c.wall->place]);
        const auto s = positive_at(csv, row, c.stress);
        if (!s)
            refuse_cell(csv, row, c.stress->place,
                        "empty cell; write the vertical stress in MPa");
        t.stress = *s * 1e6;
        t.peak = positive_at(csv, row, c.peak);
        t.stiffness = positive_at(csv, row, c.stiffness);
        read_drop(csv, row, c.drop, height, t);
        t.readings = readings_at(csv, row, c);
        const bool none = std::ranges::none_of(
            t.readings, [](const std::optional<double>& v) { return v.has_value(); });
        if (!t.peak && !t.stiffness && !t.drop && none)
            refuse_cell(csv, row, first_measured(c),
                        "nothing was measured in this row; remove it");
        if (c.censored && t.drop)
            t.censored = read_censored(csv, row, c.censored->place) || t.censored;
        t.error = error_at(csv, row, c.sigma);
        tests.push_back(std::move(t));
    }
    return tests;
}

void check_stresses(const Csv& csv, std::span<const MeasuredTest> tests,
                    std::span<const double> stresses)
{
    std::string all;
    for (const double s : stresses) all += (all.empty() ? "" : ", ") + stress_text(s);
    for (const MeasuredTest& t : tests)
        if (std::ranges::none_of(stresses, [&](double s) { return same_stress(t.stress, s); }))
            throw ConfigError(csv.path, t.line, "stress",
                              number(t.stress / 1e6, 6) +
                                  " MPa is none of the study's stresses (" + all +
                                  "); add it to load.vertical_stress");
}

bool same_stress(double a, double b) { return std::abs(a - b) <= 1e-6 * a; }

} // namespace app
