#include "app/calibration/calibration_output.hpp"
#include "app/output/table/cells.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const TestedQuantity& quantity_of(const CalibrationReport& r, const CalibratedAnswer& a)
{
    return r.data->quantities[a.kind];
}

Number interval_cell(const DrawsSummary& s, int decimals)
{
    return with_interval(s.median, s.interval, decimals);
}

/// A further wall in its shown unit; nothing where there are no draws.
Number further_cell(const Eigen::MatrixXd& ln, std::size_t answer, int decimals)
{
    if (ln.size() == 0) return {};
    std::vector<double> values;
    for (Eigen::Index k = 0; k < ln.rows(); ++k)
        values.push_back(std::exp(ln(k, static_cast<Eigen::Index>(answer))));
    return interval_cell(summary_of(values), decimals);
}

std::vector<double> scales_of(const Taught& t, std::size_t kind,
                              Eigen::VectorXd uq::CalibrationPoint::*scale)
{
    std::vector<double> values;
    for (const uq::CalibrationPoint& at : t.points)
        values.push_back((at.*scale)(static_cast<Eigen::Index>(kind)));
    return values;
}

/// Root mean square over the answers of a quantity, in percent; nothing where it is not known.
Number percent_missed(const CalibrationReport& r, std::size_t kind,
                      const std::vector<SurrogateMiss>& miss)
{
    double sum = 0.0, walls = 0.0;
    for (std::size_t a = 0; a < miss.size(); ++a) {
        if (r.data->answers[a].kind != kind) continue;
        const auto n = static_cast<double>(miss[a].walls);
        sum += n * std::pow(miss[a].root_mean_square, 2);
        walls += n;
    }
    return walls > 0.0 ? plain_number(100.0 * std::sqrt(sum / walls), 1) : Number{};
}

} // namespace

Table teaching_table(const CalibrationReport& r)
{
    Table t;
    t.title = "What the tests teach of the inputs";
    t.caption =
        "Median and 90 % interval. Moved: of the median " +
        std::string(r.study->calibration.discrepancy ? "with" : "without") +
        " discrepancy, in standard deviations of the prior (normal scores); width left: "
        "of that interval, over the prior's.";
    t.head = {"input",
              {"prior", kInterval},
              {"with discrepancy", kInterval},
              {"without", kInterval},
              "moved [sd]",
              "width left [%]"};
    for (std::size_t i = 0; i < r.inputs->inputs.size(); ++i) {
        const CalibratedInput& in = r.inputs->inputs[i];
        const InputChange c = input_change(r, i);
        const int decimals = std::max(1, decimals_for(c.prior.median));
        t.rows.push_back({with_unit(in.key, in.unit), interval_cell(c.prior, decimals),
                          interval_cell(c.with, decimals), interval_cell(c.without, decimals),
                          plain_number(c.moved, 2), plain_number(100.0 * c.width_left, 0)});
    }
    return t;
}

Table further_wall_table(const CalibrationReport& r)
{
    Table t;
    t.title = "One further wall";
    t.caption = "Median and 90 % interval. Prior: walls of the study before any test. By other "
                "stresses: without the tests under this stress.";
    t.keys = 2;
    t.head = {"quantity",
              "stress [MPa]",
              "tests",
              {"prior", kInterval},
              {"with discrepancy", kInterval},
              {"without", kInterval},
              {"by other stresses", kInterval}};
    for (std::size_t a = 0; a < r.data->answers.size(); ++a) {
        const CalibratedAnswer& answer = r.data->answers[a];
        const TestedQuantity& q = quantity_of(r, answer);
        t.rows.push_back({with_unit(q.words, q.unit), stress_cell(answer.stress),
                          count(std::ranges::count(r.data->tests, a, &UsedTest::answer)),
                          further_cell(r.run->prior, a, q.decimals),
                          further_cell(r.run->with.further, a, q.decimals),
                          further_cell(r.run->without.further, a, q.decimals),
                          further_cell(r.run->left_out[answer.level].further, a, q.decimals)});
    }
    return t;
}

Table test_table(const CalibrationReport& r)
{
    Table t;
    t.title = "Tests, and what the others say of them";
    t.caption = "Predicted: one further wall, median and 90 % interval, by the tests under all "
                "other stresses.";
    t.keys = 2;
    t.head = {"wall",
              "measured value",
              "stress [MPa]",
              {"test", kCensored},
              {"by other stresses", kInterval},
              "holds"};
    for (const UsedTest& used : r.data->tests) {
        const MeasuredTest& test = (*r.tests)[used.test];
        const CalibratedAnswer& answer = r.data->answers[used.answer];
        const TestedQuantity& q = quantity_of(r, answer);
        const Number by =
            further_cell(r.run->left_out[answer.level].further, used.answer, q.decimals);
        const bool known = std::isfinite(by.value);
        const bool holds = used.at_least ? used.value <= by.upper
                                         : used.value >= by.lower && used.value <= by.upper;
        t.rows.push_back({test.name, with_unit(q.name, q.unit), stress_cell(answer.stress),
                          Number{.value = used.value,
                                 .decimals = q.decimals,
                                 .sense = used.at_least ? Sense::above : Sense::equal},
                          by,
                          std::string(!known  ? ""
                                      : holds ? "yes"
                                              : "no")});
    }
    return t;
}

Table scatter_table(const CalibrationReport& r)
{
    const Taught& answer = answer_of((*r.study).calibration, *r.run);
    Table t;
    t.title = "How wrong the model is, and how far tests scatter";
    t.caption = "Standard deviations of ln, median and 90 % interval. Surrogate: root mean "
                "square error in percent on walls left out, and on true walls at points of the "
                "posterior.";
    t.head = {"quantity",
              "tests",
              {"discrepancy", kInterval},
              {"scatter of repeats", kInterval},
              "surrogate, left out [%]",
              "surrogate, true walls [%]"};
    for (std::size_t kind = 0; kind < r.data->quantities.size(); ++kind) {
        const TestedQuantity& q = r.data->quantities[kind];
        std::vector<SurrogateMiss> left_out;
        for (std::size_t a = 0; a < r.data->answers.size(); ++a)
            left_out.push_back({static_cast<std::size_t>(r.data->answers[a].points.y.size()),
                                r.run->surrogates[a].left_out});
        const auto tests = std::ranges::count_if(r.data->tests, [&](const UsedTest& u) {
            return r.data->answers[u.answer].kind == kind;
        });
        const bool has = r.study->calibration.discrepancy;
        t.rows.push_back(
            {q.words, count(tests),
             has ? Cell(interval_cell(
                       summary_of(scales_of(answer, kind, &uq::CalibrationPoint::tau)), 3))
                 : Cell{},
             interval_cell(summary_of(scales_of(answer, kind, &uq::CalibrationPoint::s)), 3),
             percent_missed(r, kind, left_out), percent_missed(r, kind, r.run->miss)});
    }
    return t;
}

Table evidence_table(const CalibrationReport& r)
{
    Table t;
    t.title = "Evidence";
    t.caption = "ln of the integral of prior times likelihood, by bridge sampling; between two "
                "laws with the same tests the larger one is the better bet, by exp of the "
                "difference to 1.";
    t.head = {"discrepancy", "ln evidence", "standard error", "R-hat", "effective draws"};
    const auto add = [&](const char* name, const Taught& taught) {
        const uq::CalibrationPosterior& p = taught.posterior;
        t.rows.push_back({std::string(name), plain_number(p.evidence.log_value, 3),
                          plain_number(p.evidence.std_error, 3), plain_number(p.r_hat, 4),
                          plain_number(p.effective, 0)});
    };
    add("yes", r.run->with);
    add("no", r.run->without);
    return t;
}

Table posterior_table(const CalibrationReport& r)
{
    const Taught& answer = answer_of((*r.study).calibration, *r.run);
    Table t;
    t.caption = "Points of the posterior, evenly over all chains.";
    t.keys = 1;
    t.head = {"draw"};
    for (const CalibratedInput& in : r.inputs->inputs)
        t.head.emplace_back(with_unit(in.key, in.unit));
    for (const TestedQuantity& q : r.data->quantities)
        for (const char* const what : {"discrepancy of ", "scatter of "})
            t.head.emplace_back(what + q.name);
    for (std::size_t k = 0; k < answer.points.size(); ++k) {
        const uq::CalibrationPoint& at = answer.points[k];
        Row row = {count(k)};
        const Eigen::VectorXd x = to_values(*r.inputs, at.z);
        for (std::size_t i = 0; i < r.inputs->inputs.size(); ++i)
            row.emplace_back(plain_number(
                r.inputs->inputs[i].scale * x(static_cast<Eigen::Index>(i)), kShortest));
        for (Eigen::Index kind = 0; kind < at.s.size(); ++kind) {
            row.emplace_back(plain_number(at.tau(kind), kShortest));
            row.emplace_back(plain_number(at.s(kind), kShortest));
        }
        t.rows.push_back(std::move(row));
    }
    return t;
}

} // namespace app
