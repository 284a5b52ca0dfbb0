#include "app/study/stored/wanted_walls.hpp"

#include "app/input/study_name.hpp"
#include "app/input/study_reading.hpp"
#include "app/sampling/sample_plan.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/stored/stored_study.hpp"
#include "app/study/stored/study_file_head.hpp"

#include <utility>

namespace app {

StudySource study_source(const std::string& path, std::span<const std::string> overrides,
                         Purpose purpose)
{
    if (!is_study_name(path)) {
        Study study = read_study(path, overrides, purpose);
        const std::uint32_t samples = samples_of(study.geometry, study);
        return {prepare(std::move(study)), {samples}, {}};
    }
    const StoreHead head = read_head(path);
    return {prepare(stored_study(path, head, overrides, purpose)), head.design_sizes,
            other_revision_text(head)};
}

std::vector<WantedWall> wanted_walls(const StudySource& source, const WallChoice& choice)
{
    const Study& study = source.ready.study;
    if (!choice.sample || !study.uq.drawn.empty()) return numbered_walls(source.ready, choice);
    const int samples = static_cast<int>(source.sizes.back());
    if (*choice.sample >= samples)
        throw ConfigError("drystone", 0, "--sample",
                          std::to_string(*choice.sample) + " is out of range; the study has " +
                              std::to_string(samples) +
                              (samples == 1 ? " sample" : " samples") + ", from 0");
    const int level = level_of(study.load, choice.level);
    const SamplePlan plan =
        sample_plan(study, study.load, study.source, source.ready.layout, source.sizes);
    return {{level, draw(plan, level, *choice.sample)}};
}

} // namespace app
