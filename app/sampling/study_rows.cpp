#include "app/sampling/study_rows.hpp"

#include "app/input/keys/key_values.hpp"
#include "app/input/keys/study_keys.hpp"
#include "app/input/study/distribution_text.hpp"
#include "app/sampling/study_dependence.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace app {
namespace {

constexpr const char* kTogether = "uq.together";

[[noreturn]] void refuse_rows(const StudyFile& source, const std::string& why)
{
    throw error_at(source, kTogether, why);
}

/// The values of the input at this place, in the order in which they stand there.
std::vector<double> listed_values(const Sampling& sampling, const StudyFile& source,
                                  std::size_t place)
{
    const RandomInput& input = sampling.random[place];
    if (sampling.uq.spatial != Spatial::none && input.varies != Varies::by_wall)
        refuse_rows(source, input.key + " varies from joint to joint; write uq.spatial = none");
    const Key& key = *find_key(input.key);
    const std::vector<double> values =
        empirical_values(find_entry(source, input.key)->value, key.unit);
    if (values.empty())
        refuse_rows(source, input.key + " is not a list; write empirical(...) with a value for "
                                        "each row");
    for (const double x : values)
        if (!in_range(x, key))
            throw error_at(source, input.key,
                           "a value is out of range; must be in " + allowed_values(key));
    return values;
}

} // namespace

bool is_together(const UqInput& uq, std::string_view key)
{
    return !uq.together.empty() && std::ranges::count(split(uq.together, ","), key) > 0;
}

uq::JointRows joint_rows(const Sampling& sampling, const StudyFile& source)
{
    uq::JointRows t;
    if (sampling.uq.together.empty()) return t;
    const auto dependence = dependence_of(sampling, source);
    for (const std::string_view word : split(sampling.uq.together, ",")) {
        const std::size_t place = input_named(sampling.random, source, word, kTogether);
        if (std::ranges::count(t.inputs, place) > 0)
            refuse_rows(source, std::string(word) + " is named twice; keep one");
        const auto row = static_cast<Eigen::Index>(place);
        if (dependence && (dependence->rho_z.row(row).array() != 0.0).count() > 1)
            refuse_rows(source, std::string(word) +
                                    " stands in uq.pearson too: its dependence is "
                                    "given twice; take it out of one of them");
        const std::vector<double> values = listed_values(sampling, source, place);
        if (t.inputs.empty()) t.rows.resize(values.size());
        if (values.size() != t.rows.size())
            refuse_rows(source, std::string(word) + " has " + std::to_string(values.size()) +
                                    " values, and the first input has " +
                                    std::to_string(t.rows.size()) +
                                    "; a row needs one of each");
        for (std::size_t k = 0; k < values.size(); ++k) t.rows[k].push_back(values[k]);
        t.inputs.push_back(place);
    }
    if (t.inputs.size() < 2) refuse_rows(source, "names one input; name two or more");
    std::ranges::stable_sort(t.rows, {}, [](const auto& row) { return row.front(); });
    return t;
}

} // namespace app
