#include "app/reliability/event.hpp"
#include "app/sampling/study_dependence.hpp"
#include "app/study/pushed/interrupt.hpp"
#include "app/text/words.hpp"
#include "uq/reliability/limit_state/external_program.hpp"
#include "uq/reliability/limit_state/to_variables.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace app {
namespace {

/// Words between blanks; quotes, single or double, hold blanks together.
std::vector<std::string> words_of(const StudyFile& file, const std::string& text)
{
    std::vector<std::string> words;
    std::string word;
    char quote = 0; // that is open
    bool any = false;
    for (const char c : text) {
        if (quote == 0 ? c == '"' || c == '\'' : c == quote) {
            quote = quote == 0 ? c : '\0';
            any = true;
        } else if ((c == ' ' || c == '\t') && quote == 0) {
            if (any) words.push_back(std::exchange(word, {}));
            any = false;
        } else {
            word += c;
            any = true;
        }
    }
    if (quote != 0) throw error_at(file, "model.command", "a quote is not closed");
    if (any) words.push_back(word);
    return words;
}

uq::ExternalProgram program_of(const ProgramInput& input,
                               const std::vector<RandomInput>& random, const StudyFile& source,
                               int threads)
{
    uq::ExternalProgram p;
    p.command = words_of(source, input.command);
    std::istringstream names(input.responses);
    for (std::string name; std::getline(names, name, ',');)
        p.responses.emplace_back(trimmed(name));
    for (const RandomInput& r : random) p.parameters.push_back(r.key);
    p.concurrent = input.concurrent > 0 ? input.concurrent : threads;
    p.retries = input.retries;
    p.time_limit = input.time_limit;
    p.grace = input.grace;
    p.keep = static_cast<uq::Keep>(input.keep);
    p.while_waiting = end_if_interrupted;
    return p;
}

} // namespace

uq::ReliabilityProblem program_event(const Sampling& sampling, const ProgramInput& input,
                                     const ReliabilityInput& reliability,
                                     const StudyFile& source, int threads)
{
    const uq::ExternalProgram program = program_of(input, sampling.random, source, threads);
    const std::string response =
        input.response.empty() ? program.responses.front() : input.response;
    const auto found = std::ranges::find(program.responses, response);
    if (found == program.responses.end())
        throw error_at(source, "reliability.response",
                       in_quotes(response) + " is none of model.responses");
    const bool above = input.above;
    std::vector<uq::Marginal> variables;
    for (const RandomInput& r : sampling.random) variables.push_back(r.marginal);
    uq::ReliabilityProblem p = asked_problem(sampling.uq, reliability, source,
                                             static_cast<Eigen::Index>(variables.size()));
    p.event.to_physical = uq::to_variables(variables, dependence_of(sampling, source));
    p.event.response = found - program.responses.begin();
    p.event.threshold = input.demand;
    p.event.passing = above ? uq::Passing::at_or_above : uq::Passing::at_or_below;
    p.words =
        response + (above ? " >= " : " <= ") + find_entry(source, "reliability.demand")->value;
    p.inputs = program.parameters;
    p.normal = p.inputs;
    try {
        p.event.model = uq::external_model(program);
    } catch (const std::invalid_argument& bad) {
        throw error_at(source, "model.command", bad.what());
    }
    return p;
}

} // namespace app
