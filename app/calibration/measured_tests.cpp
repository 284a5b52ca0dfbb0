#include "app/calibration/measured_tests.hpp"

#include "app/fragility/drift_csv.hpp"
#include "app/study/stored/stress_text.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace app {
namespace {

/// Nothing where the cell says that the value is not known.
std::optional<double> positive_at(const Csv& csv, const CsvRow& row,
                                  std::optional<TestColumn> column)
{
    if (!column || is_missing(trimmed(row.cells[column->place]))) return {};
    const double x = number_at(csv, row, column->place);
    if (!(x > 0.0))
        refuse_cell(csv, row, column->place,
                    "must be above 0; write NA if it was not measured");
    if (!(x >= kLeastValue && x <= kMostValue))
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
