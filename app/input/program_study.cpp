/// Studies of another program.

#include "app/input/keys/key_reading.hpp"
#include "app/input/study/distribution_text.hpp"
#include "app/input/study/units.hpp"
#include "app/input/study_reading.hpp"

namespace app {
namespace {

RandomInput variable(const StudyFile& file, const Entry& entry)
{
    RandomInput input;
    input.key = name_in_section(entry.key);
    input.marginal = read_at(file, entry.key, [&] {
        return is_distribution(entry.value)
                   ? parse_distribution(entry.value, "")
                   : uq::Marginal{uq::Constant{parse_quantity(entry.value, "")}};
    });
    input.mean = uq::mean(input.marginal);
    return input;
}

} // namespace

bool is_program_study(const StudyFile& file) { return find_section(file, "model") != nullptr; }

Study read_program_study(const StudyFile& file)
{
    refuse_unknown(file, program_keys(), "variables");
    Study study;
    study.source = file;
    for (const Key& key : program_keys()) read_key(key, study);
    for (const Entry& entry : file.entries)
        if (section_of(entry.key) == "variables") study.random.push_back(variable(file, entry));
    if (study.random.empty())
        throw error_at(
            file, "variables.name",
            "no variable; write e.g. \"friction = normal(mean 31.8, cov 0.20)\" under "
            "[variables], in the unit of the program and without one");
    if (study.reliability.method == ReliabilityMethod::multi_fidelity)
        throw error_at(file, "reliability.method",
                       "multi_fidelity needs a wall; write monte_carlo, form, importance, "
                       "subset or active");
    return study;
}

} // namespace app
