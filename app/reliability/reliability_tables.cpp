#include "app/reliability/reliability_tables.hpp"

#include "app/output/table/cells.hpp"
#include "app/text/number_text.hpp"
#include "core/normal.hpp"

#include <cmath>
#include <optional>

namespace app {
namespace {

/// Shown with four digits; a small probability in powers of ten, since decimals would hide it.
Number cell(const std::optional<double>& x)
{
    constexpr double kSmall = 1e-4;
    if (!x) return {};
    return std::abs(*x) < kSmall ? plain_number(rounded(*x, 4), kShortest)
                                 : plain_number(*x, decimals_for(*x) + 1);
}

std::string evaluations_text(const uq::ReliabilityProblem& p, const uq::ReliabilityAnswer& a)
{
    const std::string all = std::to_string(a.evaluations) + " evaluations, ";
    if (a.failed.empty()) return all + "none failed.";
    return all + std::to_string(a.failed.size()) +
           (p.method == uq::ReliabilityMethod::active
                ? " failed: the bounds assume the worst and the best case of those among the "
                  "checks, which are few; subset or monte_carlo counts all that fail."
                : " failed: the bounds assume the worst and the best case of these.");
}

Table method_table(const uq::ReliabilityProblem& p, const uq::ReliabilityAnswer& a)
{
    Table t;
    t.title = "P(" + p.words + ")";
    t.caption = "Intervals are 95 %. " + evaluations_text(p, a);
    t.head = {"method", "probability",     "beta", "standard error", "lower",
              "upper",  {"outcome", kNote}};
    for (const uq::MethodAnswer& m : a.methods) {
        std::optional<double> beta;
        if (m.probability && *m.probability > 0.0 && *m.probability < 1.0)
            beta = -core::normal_quantile(*m.probability);
        t.rows.push_back({m.method, cell(m.probability), cell(beta), cell(m.std_error),
                          cell(m.lower), cell(m.upper), m.outcome});
    }
    return t;
}

/// The response that is sought, in the unit in which people read it.
Table quantile_table(const Question& q, const uq::ReliabilityAnswer& a)
{
    Table t;
    t.title = quantile_words(q.problem);
    t.caption = "Intervals are 95 %; an end that is missing is not known. " +
                evaluations_text(q.problem, a);
    t.head = {"method", q.response.name, "lower", "upper", {"outcome", kNote}};
    const auto shown = [&](const std::optional<double>& x) {
        return x ? cell(q.response.scale * *x) : Number{};
    };
    for (const uq::MethodAnswer& m : a.methods)
        t.rows.push_back(
            {m.method, shown(m.quantile), shown(m.lower), shown(m.upper), m.outcome});
    return t;
}

} // namespace

std::string quantile_words(const uq::ReliabilityProblem& p)
{
    return number(100.0 * p.quantile, 6) + " % quantile of " + p.words;
}

Table answer_table(const Question& q, const uq::ReliabilityAnswer& a)
{
    return q.problem.quantile > 0.0 ? quantile_table(q, a) : method_table(q.problem, a);
}

Table sensitivity_table(const uq::ReliabilityAnswer& a)
{
    Table t;
    t.title = "What the response depends on";
    t.caption = "Intervals are 95 %.";
    t.head = {"measure", "input", {"value", kInterval | kError}};
    t.keys = 2;
    for (const uq::Sensitivity& s : a.sensitivities)
        for (const uq::InputShare& i : s.shares)
            t.rows.push_back({s.measure, i.input,
                              Number{.value = i.value,
                                     .error = i.std_error.value_or(kUnknown),
                                     .lower = i.lower.value_or(kUnknown),
                                     .upper = i.upper.value_or(kUnknown),
                                     .decimals = 3}});
    return t;
}

Table point_table(const Question& q, const uq::ReliabilityAnswer& a)
{
    Table t;
    t.title = "Design points, nearest first";
    t.caption = "The most probable values at which the event begins.";
    t.head = {"point", "beta", "input", "value"};
    for (std::size_t k = 0; k < a.points.size(); ++k)
        for (std::size_t i = 0; i < q.inputs.size(); ++i)
            t.rows.push_back(
                {count(static_cast<double>(k + 1)), cell(a.points[k].beta), q.inputs[i].name,
                 cell(q.inputs[i].scale * a.points[k].x(static_cast<Eigen::Index>(i)))});
    return t;
}

Table evaluation_table(const Question& q, const std::vector<uq::Evaluated>& seen)
{
    Table t;
    for (const ShownNumber& input : q.inputs) t.head.emplace_back(input.name);
    t.head.insert(t.head.end(), {q.response.name, "failure"});
    for (const uq::Evaluated& e : seen) {
        Row row;
        for (std::size_t i = 0; i < q.inputs.size(); ++i)
            row.emplace_back(Number{q.inputs[i].scale * e.x(static_cast<Eigen::Index>(i))});
        row.emplace_back(e.failure.empty() ? Number{q.response.scale * e.response} : Number{});
        row.emplace_back(e.failure);
        t.rows.push_back(row);
    }
    return t;
}

} // namespace app
