#include "app/reliability/reliability_command.hpp"

#include "app/input/number_text.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/table.hpp"
#include "app/reliability/methods.hpp"
#include "app/study/wanted_walls.hpp"

#include <gsl/gsl_cdf.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>

namespace app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string cell(const std::optional<double>& x) { return x ? number(*x, 4) : ""; }

Table method_table(const ReliabilityProblem& p, const ReliabilityAnswer& a)
{
    Table t;
    t.caption = "P(" + p.words + "). Intervals 95 %; of " + std::to_string(a.evaluations) +
                " evaluations " + std::to_string(a.failed.size()) +
                " failed, which count either way in the bounds.";
    t.head = {"method", "probability", "beta", "standard error", "lower", "upper", "outcome"};
    for (const MethodAnswer& m : a.methods) {
        std::optional<double> beta;
        if (m.probability && *m.probability > 0.0 && *m.probability < 1.0)
            beta = -gsl_cdf_ugaussian_Pinv(*m.probability);
        t.rows.push_back({m.method, cell(m.probability), cell(beta), cell(m.std_error),
                          cell(m.lower), cell(m.upper), m.outcome});
    }
    return t;
}

Table share_table(const ReliabilityAnswer& a)
{
    Table t;
    t.caption = "Sensitivity: " + a.share_name + ".";
    t.head = {"input", "value", "lower", "upper"};
    for (const InputShare& s : a.shares)
        t.rows.push_back({s.input, number(s.value, 3), cell(s.lower), cell(s.upper)});
    return t;
}

Table evaluation_table(const ReliabilityProblem& p, const std::vector<Evaluated>& seen)
{
    Table t;
    t.head = p.inputs;
    t.head.insert(t.head.end(), {"response", "failure"});
    for (const Evaluated& e : seen) {
        std::vector<std::string> row;
        for (const double x : e.x) row.push_back(number(x, 17));
        row.push_back(e.failure.empty() ? number(e.response, 17) : "");
        row.push_back(e.failure);
        t.rows.push_back(row);
    }
    return t;
}

Json json(const std::optional<double>& x)
{
    return x && std::isfinite(*x) ? Json(*x) : Json(nullptr);
}

std::string answer_json(const ReliabilityProblem& p, const ReliabilityAnswer& a)
{
    Json all = {{"event", p.words},
                {"evaluations", a.evaluations},
                {"failed", a.failed.size()},
                {"methods", Json::array()},
                {"sensitivity", {{"meaning", a.share_name}, {"inputs", Json::array()}}},
                {"warnings", a.warnings}};
    for (const MethodAnswer& m : a.methods)
        all["methods"].push_back({{"method", m.method},
                                  {"probability", json(m.probability)},
                                  {"standard_error", json(m.std_error)},
                                  {"lower", json(m.lower)},
                                  {"upper", json(m.upper)},
                                  {"outcome", m.outcome}});
    for (const InputShare& s : a.shares)
        all["sensitivity"]["inputs"].push_back({{"input", s.input},
                                                {"value", json(s.value)},
                                                {"lower", json(s.lower)},
                                                {"upper", json(s.upper)}});
    return all.dump(2) + "\n";
}

void write_table(const fs::path& out, const std::string& name, const Table& table)
{
    write_file(out / (name + ".csv"), as_csv(table));
    write_file(out / (name + ".md"), as_markdown(table));
    write_file(out / (name + ".tex"), as_latex(table));
}

ReliabilityProblem problem_of(const Command& command)
{
    const StudyFile file = with_overrides(read_study_file(command.study), command.overrides);
    return is_external(file) ? external_problem(file, command)
                             : wall_problem(read_study(file), command);
}

} // namespace

int reliability_command(const Command& command)
{
    const ReliabilityProblem problem = problem_of(command);
    std::vector<Evaluated> seen;
    const ReliabilityAnswer a = answer(problem, seen);
    const fs::path out = command.out;
    make_folder(out);
    const Table methods = method_table(problem, a);
    write_table(out, "reliability", methods);
    if (!a.shares.empty()) write_table(out, "sensitivity", share_table(a));
    write_file(out / "evaluations.csv", as_csv(evaluation_table(problem, seen)));
    write_file(out / "reliability.json", answer_json(problem, a));
    std::cout << methods.caption << "\n\n" << as_text(methods);
    if (!a.shares.empty())
        std::cout << "\nSensitivity: " << a.share_name << "\n\n" << as_text(share_table(a));
    for (const std::string& w : a.warnings) std::cout << "warning: " << w << '\n';
    std::cout << "written to " << command.out << '\n';
    const bool any = std::any_of(a.methods.begin(), a.methods.end(), [](const MethodAnswer& m) {
        return m.probability || m.upper;
    });
    return any ? 0 : 1;
}

} // namespace app
