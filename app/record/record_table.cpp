#include "app/record/record_table.hpp"

#include "app/output/table/cells.hpp"
#include "ground/motion_facts.hpp"

#include <cmath>

namespace app {
namespace {

Number three_digits(double x) { return plain_number(x, decimals_for(std::abs(x))); }

std::string remarks_of(const ground::Record& r, const ground::MotionFacts& facts)
{
    std::string text;
    for (const std::string& remark : r.remarks) text += (text.empty() ? "" : "; ") + remark;
    if (const std::string why = ground::unfit_motion(facts); !why.empty())
        text += (text.empty() ? "" : "; ") + why;
    return text;
}

} // namespace

std::vector<ground::Measure> usual_measures()
{
    using enum ground::MeasureKind;
    return {{sa, 0.2}, {sa, 0.5}, {sa, 1.0}, {sa, 2.0}};
}

Table record_table(const std::vector<ground::Record>& records,
                   const std::vector<ground::Measure>& measures)
{
    using enum ground::MeasureKind;
    Table t;
    t.title = "Records";
    t.caption =
        "Motions as they were read. PGA, PGV, PGD: largest absolute acceleration, velocity and "
        "displacement, of ground that starts at rest with accelerations that are linear "
        "between "
        "samples; the last velocity in percent of the PGV; D5-95: time between 5 and 95 % of "
        "the "
        "Arias intensity; CAV: cumulative absolute velocity; sa: pseudo-acceleration at 5 % of "
        "damping.";
    t.head = {"motion",           "format",
              "unit of the file", "step [s]",
              "samples",          "duration [s]",
              "PGA [g]",          "PGV [m/s]",
              "PGD [m]",          "last velocity [% of PGV]",
              "D5-95 [s]",        "Arias [m/s]",
              "CAV [m/s]"};
    for (const ground::Measure& m : measures)
        t.head.emplace_back(measure_text(m) + " [" + std::string(measure_unit(m)) + "]");
    t.head.emplace_back("note", kNote);
    for (const ground::Record& r : records) {
        const ground::GroundMotion& m = r.motion;
        const ground::MotionFacts f = motion_facts(m);
        Row row = {m.name,
                   r.format,
                   r.unit,
                   given(m.step),
                   count(m.acceleration.size()),
                   given(f.duration),
                   three_digits(f.pga / ground::kGravity),
                   three_digits(f.pgv),
                   three_digits(f.pgd),
                   plain_number(f.pgv > 0.0 ? 100.0 * f.final_velocity / f.pgv : 0.0, 1),
                   three_digits(intensity(m, {duration})),
                   three_digits(intensity(m, {arias})),
                   three_digits(intensity(m, {cav}))};
        for (const ground::Measure& measure : measures)
            row.emplace_back(three_digits(intensity(m, measure) / measure_unit_value(measure)));
        add_row(t, row, remarks_of(r, f));
    }
    return t;
}

std::vector<double> spectrum_periods()
{
    constexpr int kPeriods = 80;
    constexpr double kFirst = 0.04, kLast = 4.0;
    std::vector<double> periods;
    for (int i = 0; i < kPeriods; ++i)
        periods.push_back(kFirst * std::pow(kLast / kFirst, i / (kPeriods - 1.0)));
    return periods;
}

Table spectrum_table(const std::vector<ground::Record>& records,
                     const std::vector<std::vector<double>>& spectra)
{
    Table t;
    t.head = {"period [s]"};
    for (const ground::Record& r : records) t.head.emplace_back(r.motion.name + " [g]");
    const std::vector<double> periods = spectrum_periods();
    for (std::size_t i = 0; i < periods.size(); ++i) {
        Row row = {Number{periods[i]}};
        for (const auto& spectrum : spectra) row.emplace_back(Number{spectrum[i]});
        t.rows.push_back(row);
    }
    return t;
}

} // namespace app
