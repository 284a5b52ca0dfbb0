#include "app/commands.hpp"
#include "app/input/study_reading.hpp"

#include "app/input/key_effects.hpp"
#include "app/output/atomic_output.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/progress.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/table_files.hpp"
#include "app/reliability/evaluation_identity.hpp"
#include "app/reliability/event.hpp"
#include "app/reliability/reliability_tables.hpp"
#include "app/store/continued_head.hpp"
#include "app/store/store_head.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/text/config_error.hpp"
#include "app/text/json_text.hpp"
#include "uq/reliability/limit_state/kept_evaluations.hpp"
#include "uq/reliability/reliability.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <span>
#include <stdexcept>

namespace app {
namespace {

namespace fs = std::filesystem;
Json share_json(const uq::InputShare& i)
{
    return {{"input", i.input},
            {"value", or_null(i.value)},
            {"standard_error", or_null(i.std_error)},
            {"lower", or_null(i.lower)},
            {"upper", or_null(i.upper)}};
}

Json point_json(const Question& q, const uq::DesignPointFound& point)
{
    Json values = Json::object();
    for (std::size_t i = 0; i < q.inputs.size(); ++i)
        values[q.inputs[i].name] = q.inputs[i].scale * point.x(static_cast<Eigen::Index>(i));
    return {{"beta", point.beta},
            {"standard_normal", std::vector<double>(point.u.begin(), point.u.end())},
            {"inputs", values}};
}

std::string answer_json(const Question& q, const uq::ReliabilityAnswer& a)
{
    Json all = {{"event", q.problem.words},     {"evaluations", a.evaluations},
                {"failed", a.failed.size()},    {"methods", Json::array()},
                {"sensitivity", Json::array()}, {"design_points", Json::array()},
                {"warnings", a.warnings}};
    const auto shown = [&](const std::optional<double>& x) {
        return x ? or_null(q.response.scale * *x) : Json();
    };
    if (q.problem.quantile > 0.0) {
        all["event"] = quantile_words(q.problem);
        all["quantile"] = q.problem.quantile;
        for (const uq::MethodAnswer& m : a.methods)
            all["methods"].push_back({{"method", m.method},
                                      {q.response.name, shown(m.quantile)},
                                      {"lower", shown(m.lower)},
                                      {"upper", shown(m.upper)},
                                      {"outcome", m.outcome}});
    } else
        for (const uq::MethodAnswer& m : a.methods)
            all["methods"].push_back({{"method", m.method},
                                      {"probability", or_null(m.probability)},
                                      {"standard_error", or_null(m.std_error)},
                                      {"lower", or_null(m.lower)},
                                      {"upper", or_null(m.upper)},
                                      {"outcome", m.outcome}});
    for (const uq::Sensitivity& s : a.sensitivities) {
        Json inputs = Json::array();
        for (const uq::InputShare& i : s.shares) inputs.push_back(share_json(i));
        all["sensitivity"].push_back({{"measure", s.measure}, {"inputs", inputs}});
    }
    for (const uq::DesignPointFound& point : a.points)
        all["design_points"].push_back(point_json(q, point));
    // Reasons may quote what another program printed, in any encoding.
    return text_of(all, 2) + "\n";
}

constexpr std::string_view kReliabilityList = "drystone_reliability_files.txt";
constexpr const char* kEvaluations = "evaluations.csv";

/// Before anything is evaluated: what could not be written afterwards.
void check_folder(const Command& command)
{
    std::vector<fs::path> names = {kEvaluations, "reliability.json"};
    for (const std::string name : {"reliability", "sensitivity", "design_points"})
        for (const char* const ending : kTableEndings) names.push_back(name + ending);
    if (const std::string note = check_results(command.out, names, kReliabilityList);
        !command.quiet)
        std::cerr << note;
}

Question question_of(const Command& command)
{
    const StudyFile file = with_overrides(read_study_file(command.study), command.overrides);
    const bool program = is_program_study(file);
    const PreparedStudy ready =
        program ? PreparedStudy{read_program_study(file), {}} : prepare(read_study(file));
    const Study& study = ready.study;
    const uq::ReliabilityProblem problem =
        program ? program_event(study, study.program, study.reliability, study.source,
                                command.threads)
                : wall_problem(ready, command.level, command.threads);
    Question q{problem, shown_inputs(study.program, study.random, problem.inputs),
               shown_response(study.reliability, study.program, problem),
               program ? program_evaluations(study) : wall_evaluations(study, command.level)};
    q.model += "response = " + std::to_string(q.problem.event.response) + '\n';
    std::cerr << study_notes(ready, command.verb);
    return q;
}

void write(const Command& command, const Question& q, const uq::ReliabilityAnswer& a,
           const std::vector<uq::Evaluated>& seen)
{
    std::vector<OutputFile> files = {{kEvaluations, as_csv(evaluation_table(q, seen))}};
    const Table sensitivity = sensitivity_table(a);
    add_table(files, "reliability", answer_table(q, a));
    if (!sensitivity.rows.empty()) add_table(files, "sensitivity", sensitivity);
    if (!a.points.empty()) add_table(files, "design_points", point_table(q, a));
    files.push_back({"reliability.json", answer_json(q, a)});
    write_results(command.out, files, kReliabilityList);
}

/// Prints the title above the numbers.
void print(const Table& table)
{
    std::cout << table.title << ". " << table.caption << "\n\n"
              << as_text(table, terminal_width());
}

void say(const Command& command, const Question& q, const uq::ReliabilityAnswer& a)
{
    print(answer_table(q, a));
    if (const Table sensitivity = sensitivity_table(a); !sensitivity.rows.empty()) {
        std::cout << '\n';
        print(sensitivity);
    }
    for (const std::string& w : a.warnings) std::cout << "warning: " << w << '\n';
    std::cout << "written to " << command.out << '\n';
}

/// Evaluations that an interrupted run has left in the folder of the results.
/// @throws ConfigError if it is of another study
uq::KeptEvaluations kept_in(const Command& command, const std::string& model)
{
    const fs::path file = fs::path(command.out) / "unfinished.jsonl";
    try {
        return uq::KeptEvaluations(file, model);
    } catch (const uq::KeptEvaluations::OtherModel& other) {
        const std::string before = solver_revision(other.model), now = solver_revision(model);
        throw ConfigError(
            "drystone", 0, "--out",
            "'" + file.string() + "' holds the evaluations of an interrupted run of " +
                (before == now
                     ? "another study; remove it, or name another folder"
                     : revision_words(before) + ". This program has " + revision_words(now) +
                           ", which gives other numbers for the same walls; finish "
                           "the run with the version that began it, or name another "
                           "folder"));
    }
}

/// Thrown where no evaluation is sound, so that no more are paid for. It is no std::exception,
/// which would be the failure of its batch.
struct NoneSound {
    std::size_t tried;
    std::string first; ///< why the first of them failed
};

void end_if_none_sound(const std::vector<uq::Evaluated>& seen)
{
    if (seen.size() >= uq::kUntilSound &&
        std::ranges::none_of(seen, [](const uq::Evaluated& e) { return e.failure.empty(); }))
        throw NoneSound{seen.size(), seen.front().failure};
}

/// The answer; the evaluations are written whether there is one or not.
uq::ReliabilityAnswer answered(const Command& command, const Question& question)
{
    make_folder(command.out);
    uq::KeptEvaluations kept = kept_in(command, question.model);
    if (kept.found() > 0 && !command.quiet)
        std::cerr << "resuming: " << kept.found() << " evaluations were made earlier\n";
    uq::ReliabilityProblem problem = question.problem;
    problem.event.model = kept.around(problem.event.model, problem.event.response);
    problem.event.response = 0;
    Progress progress(std::cerr, stderr_progress(command.quiet), steady_seconds);
    std::vector<uq::Evaluated> seen;
    const auto on_batch = [&](std::span<const uq::Evaluated> batch) {
        seen.insert(seen.end(), batch.begin(), batch.end());
        progress.update(static_cast<double>(seen.size()) / problem.budget,
                        std::to_string(seen.size()) + " evaluations");
        end_if_interrupted();
        if (seen.size() < static_cast<std::size_t>(problem.budget)) end_if_none_sound(seen);
    };
    try {
        const uq::ReliabilityAnswer a = uq::reliability(problem, on_batch);
        write(command, question, a, seen);
        kept.remove();
        progress.finish(std::to_string(seen.size()) + " evaluations");
        return a;
    } catch (const NoneSound& none) {
        write_results(command.out, {{kEvaluations, as_csv(evaluation_table(question, seen))}},
                      kReliabilityList);
        kept.remove(); // what is mended may answer
        throw std::runtime_error("the first " + std::to_string(none.tried) + " of " +
                                 std::to_string(problem.budget) +
                                 " evaluations all failed, and no more were made; " +
                                 "the first failed because: " + none.first +
                                 ". All of them are in " +
                                 (fs::path(command.out) / kEvaluations).string());
    } catch (const uq::KeptEvaluations::NotKept& full) {
        throw std::runtime_error(full.what +
                                 "; make space there and run the same command again");
    } catch (...) {
        write_results(command.out, {{kEvaluations, as_csv(evaluation_table(question, seen))}},
                      kReliabilityList);
        throw;
    }
}

} // namespace

int reliability_command(const Command& command)
{
    const Question question = question_of(command);
    check_folder(command);
    catch_interrupts();
    try {
        const uq::ReliabilityAnswer a = answered(command, question);
        say(command, question, a);
        const bool any = std::ranges::any_of(a.methods, [](const uq::MethodAnswer& m) {
            return m.probability || m.quantile || m.lower || m.upper;
        });
        return any && a.failed.size() < a.evaluations ? 0 : 1;
    } catch (const Interrupted&) {
        throw Interrupted{"the evaluations made so far are in " + command.out +
                          "/evaluations.csv, and the same command continues with them"};
    }
}

} // namespace app
