#include "app/study/stored/study_file_head.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/random_layouts.hpp"
#include "app/store/continued_head.hpp"
#include "app/store/store_reader.hpp"
#include "app/store/wall_file.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/pier_columns.hpp"
#include "app/study/stored/study_columns.hpp"
#include "app/study/stored/study_identity.hpp"
#include "app/text/config_error.hpp"
#include "dem/solver/solver_revision.hpp"

#include <algorithm>

namespace app {

std::uint32_t samples_of(const GeometryInput& geometry, const Sampling& sampling)
{
    return is_random(geometry, sampling.random)
               ? static_cast<std::uint32_t>(sampling.uq.samples)
               : 1u;
}

void check_is_study(const std::filesystem::path& file)
{
    if (std::filesystem::exists(file) && !begins_as_hdf5(file))
        throw ConfigError(
            file.string(), 0, "",
            "is not the file of a study; give the FILE.h5 that drystone study wrote");
}

std::vector<std::uint32_t> design_sizes(const GeometryInput& geometry, const Sampling& sampling,
                                        const std::filesystem::path& file)
{
    const std::uint32_t samples = samples_of(geometry, sampling);
    std::vector<std::uint32_t> sizes;
    if (std::filesystem::exists(file)) sizes = read_head(file).design_sizes;
    if (sizes.empty() || samples > sizes.back()) sizes.push_back(samples);
    const bool rule = sampling.uq.stop != kNoStop;
    if (!rule && samples < sizes.back())
        sizes = {samples}; // fewer than there are: refused later
    return sizes;
}

std::string other_revision_text(const StoreHead& head)
{
    const std::string mine = std::to_string(dem::kSolverRevision);
    const std::string theirs = solver_revision(head.identity);
    if (theirs == mine) return "";
    return "The walls of this file were pushed by " + revision_words(theirs) +
           ". This program has revision " + mine +
           ", which gives other numbers for the same walls (CHANGELOG.md).";
}

StoreHead head_of(const Study& study, const dem::Layout& layout, const SamplePlan& plan,
                  std::vector<std::uint32_t> sizes)
{
    StoreHead head;
    head.configuration = effective_configuration(study);
    head.identity = identity_text(study);
    for (const double stress : study.load.vertical_stress)
        head.levels.push_back({stress, sizes.back()});
    if (pushes_both_ways(study.geometry, study.load, study.source, layout))
        for (const double stress : study.load.vertical_stress)
            head.levels.push_back({stress, sizes.back(), 1, true});
    const auto audit = std::min<std::uint32_t>(sizes.back(), study.uq.audit);
    for (const double stress : study.load.vertical_stress)
        if (audit > 0) head.levels.push_back({stress, audit, kAuditSlower});
    head.design_sizes = std::move(sizes);
    head.seed = study.uq.seed;
    head.inputs = input_columns(plan);
    head.responses = response_columns();
    head.counts = count_columns();
    head.cost = cost_columns();
    head.piers = stored_piers_of(study, study.load);
    head.spandrels = stored_spandrels_of(study, study.load);
    head.single_precision_curves = study.output.single_precision_curves;
    return head;
}

} // namespace app
