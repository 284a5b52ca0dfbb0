#include "app/reliability/event.hpp"
#include "app/reliability/methods.hpp"
#include "app/sampling/study_dependence.hpp"
#include "app/study/interrupt.hpp"
#include "app/text/words.hpp"
#include "uq/designs/normal_copula.hpp"
#include "uq/reliability/external_program.hpp"

#include <algorithm>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace app {
namespace {

/// Words between blanks; quotes hold blanks together.
std::vector<std::string> words_of(const StudyFile& file, const std::string& text)
{
    std::vector<std::string> words;
    std::string word;
    bool quoted = false, any = false;
    for (const char c : text) {
        if (c == '"') {
            quoted = !quoted;
            any = true;
        } else if ((c == ' ' || c == '\t') && !quoted) {
            if (any) words.push_back(std::exchange(word, {}));
            any = false;
        } else {
            word += c;
            any = true;
        }
    }
    if (quoted) throw error_at(file, "model.command", "a quote is not closed");
    if (any) words.push_back(word);
    return words;
}

uq::Map map_of(const Study& study)
{
    const auto d = static_cast<Eigen::Index>(study.random.size());
    const std::optional<uq::NormalCopula> dependence = dependence_of(study);
    const Eigen::MatrixXd factor =
        dependence ? dependence->factor : Eigen::MatrixXd(Eigen::MatrixXd::Identity(d, d));
    return [factor, inputs = study.random](const Eigen::MatrixXd& u) {
        Eigen::MatrixXd x = u * factor.transpose();
        for (std::size_t j = 0; j < inputs.size(); ++j)
            for (double& value : x.col(static_cast<Eigen::Index>(j)))
                value = uq::from_normal(inputs[j].marginal, value);
        return x;
    };
}

uq::ExternalProgram program_of(const Study& study, int threads)
{
    const ProgramInput& input = study.program;
    uq::ExternalProgram p;
    p.command = words_of(study.source, input.command);
    std::istringstream names(input.responses);
    for (std::string name; std::getline(names, name, ',');)
        p.responses.emplace_back(trimmed(name));
    for (const RandomInput& r : study.random) p.parameters.push_back(r.key);
    p.concurrent = input.concurrent > 0 ? input.concurrent : threads;
    p.retries = input.retries;
    p.time_limit = input.time_limit;
    p.grace = input.grace;
    p.keep = static_cast<uq::Keep>(input.keep);
    p.while_waiting = [] {
        if (interrupted()) throw Interrupted();
    };
    return p;
}

} // namespace

ReliabilityProblem program_event(const Study& study, int threads)
{
    const uq::ExternalProgram program = program_of(study, threads);
    const std::string response =
        study.program.response.empty() ? program.responses.front() : study.program.response;
    const auto found = std::find(program.responses.begin(), program.responses.end(), response);
    if (found == program.responses.end())
        throw error_at(study.source, "reliability.response",
                       in_quotes(response) + " is none of model.responses");
    const bool above = study.program.above;
    ReliabilityProblem p;
    p.event.to_physical = map_of(study);
    p.event.dimension = static_cast<Eigen::Index>(study.random.size());
    p.event.response = found - program.responses.begin();
    p.event.threshold = study.program.demand;
    p.event.passing = above ? uq::Passing::at_or_above : uq::Passing::at_or_below;
    p.words = response + (above ? " >= " : " <= ") +
              find_entry(study.source, "reliability.demand")->value;
    p.inputs = program.parameters;
    p.normal = p.inputs;
    p.method = study.reliability.method;
    p.budget = study.reliability.budget;
    if (const std::string why = too_small(p.method, p.budget, p.event.dimension); !why.empty())
        throw error_at(study.source, "reliability.budget", why);
    if (p.method == ReliabilityMethod::sobol && !study.uq.pearson.empty())
        throw error_at(
            study.source, "uq.pearson",
            "has no meaning for reliability.method = sobol: Sobol' indices are shares "
            "of independent inputs; leave it out");
    p.target_cov = study.reliability.target_cov;
    p.seed = study.uq.seed;
    try {
        p.event.model = uq::external_model(program);
    } catch (const std::invalid_argument& bad) {
        throw error_at(study.source, "model.command", bad.what());
    }
    return p;
}

} // namespace app
