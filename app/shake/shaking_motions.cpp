#include "app/shake/shaking_motions.hpp"

#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"
#include "ground/intensity.hpp"
#include "ground/motion_facts.hpp"
#include "ground/pulse.hpp"
#include "ground/record.hpp"
#include "ground/record_error.hpp"
#include "ground/stochastic_motion.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace app {
namespace {

/// A wall whose top moves less in a second after the record has come to its residual drift [-].
constexpr double kQuietDrift = 1e-4; // choice: a twentieth of the least limit of residual drift

/// A file that a key names. A study that was stored names it by its whole path, and
/// both may have moved together.
std::filesystem::path record_path(const StudyFile& file, const char* key,
                                  const std::string& text)
{
    const std::filesystem::path folder = std::filesystem::path(file.path).parent_path();
    const std::filesystem::path there = path_from(file, key, text),
                                beside = folder / there.filename();
    std::error_code error;
    const bool moved = std::filesystem::path(text).is_absolute() &&
                       !std::filesystem::exists(there, error) &&
                       std::filesystem::exists(beside, error);
    return moved ? beside : there;
}

std::vector<ground::GroundMotion> motions_of(const StudyFile& file, const char* key,
                                             const std::string& text)
{
    if (text.empty())
        throw error_at(file, key, "an empty name between commas; write a file or a pulse");
    if (ground::is_stochastic(text))
        return read_at(file, key, [&] { return ground::stochastic_motions(text); });
    if (ground::is_pulse(text))
        return read_at(file, key,
                       [&] { return std::vector<ground::GroundMotion>{ground::pulse(text)}; });
    if (text.ends_with(')') && !std::filesystem::exists(record_path(file, key, text)))
        throw error_at(file, key,
                       in_quotes(text) +
                           " is neither a file nor a motion by formula; these are " +
                           ground::pulse_names() + " and kanai_tajimi");
    const std::string path = record_path(file, key, text).string();
    try {
        std::vector<ground::GroundMotion> all;
        for (ground::Record& r : ground::read_records(path)) {
            ground::check_motion(path, r.motion);
            all.push_back(std::move(r.motion));
        }
        return all;
    } catch (const ground::RecordError& bad) {
        throw error_at(file, key, bad.what());
    }
}

/// The vertical motion beside a horizontal one: as many samples, zeros where it is over.
ground::GroundMotion beside(ground::GroundMotion vertical, const ground::GroundMotion& m,
                            const StudyFile& file)
{
    if (vertical.step != m.step)
        throw error_at(file, "shaking.vertical",
                       "must have the time step of " + in_quotes(m.name) + ", " +
                           number(m.step, 6) + " s; resample it");
    if (vertical.acceleration.size() > m.acceleration.size())
        throw error_at(file, "shaking.vertical",
                       "lasts longer than " + in_quotes(m.name) + "; cut it to its length");
    vertical.acceleration.resize(m.acceleration.size(), 0.0);
    return vertical;
}

} // namespace

ShakingRecords shaking_records(const ShakingInput& given, const StudyFile& file)
{
    if (given.records.empty())
        throw error_at(file, "shaking.records",
                       "missing; write files of records or pulses, e.g. records = "
                       "half_sine(peak 0.5 g, duration 0.3 s)");
    ShakingRecords all;
    all.at = shaken_intensities(given, file);
    std::optional<ground::GroundMotion> vertical;
    if (given.vertical != "none")
        vertical = motions_of(file, "shaking.vertical", given.vertical).front();
    for (const std::string& part : split_outside_brackets(given.records))
        for (ground::GroundMotion& m : motions_of(file, "shaking.records", part)) {
            ShakingRecord r;
            r.own = intensity(m, all.at.measure);
            if (r.own <= 0.0)
                throw error_at(file, "shaking.records", in_quotes(m.name) + " does not move");
            if (vertical) r.vertical = beside(*vertical, m, file);
            r.horizontal = std::move(m);
            all.records.push_back(std::move(r));
        }
    return all;
}

std::size_t intensity_count(const ShakingRecords& records)
{
    return std::max<std::size_t>(1, records.at.values.size());
}

ShakingMotion shaking_motion(const ShakingRecords& all, std::size_t record,
                             std::size_t intensity)
{
    const ShakingRecord& r = all.records.at(record);
    ShakingMotion m{
        r.horizontal.name + intensity_text(all.at, intensity), all.at.scale, {}, {}};
    if (!all.at.values.empty()) m.factor = all.at.scale * all.at.values.at(intensity) / r.own;
    m.horizontal = scaled(r.horizontal, m.factor);
    if (r.vertical) m.vertical = scaled(*r.vertical, m.factor);
    return m;
}

std::vector<ShakingMotion> shaking_motions(const ShakingInput& shaking, const StudyFile& source)
{
    const ShakingRecords records = shaking_records(shaking, source);
    std::vector<ShakingMotion> all;
    for (std::size_t r = 0; r < records.records.size(); ++r)
        for (std::size_t i = 0; i < intensity_count(records); ++i)
            all.push_back(shaking_motion(records, r, i));
    return all;
}

dem::ShakePlan shake_plan(const LoadInput& load, const ShakingInput& shaking,
                          const ShakingMotion& motion)
{
    dem::ShakePlan plan;
    plan.step = motion.horizontal.step;
    plan.horizontal = motion.horizontal.acceleration;
    if (motion.vertical) plan.vertical = motion.vertical->acceleration;
    plan.load = load.mass;
    plan.contact_damping = shaking.contact_damping;
    plan.quiet = kQuietDrift;
    return plan;
}

void check_shaken_study(const Masonry& masonry, const dem::SolverOptions& solver,
                        const ShakingInput& shaking, const StudyFile& source)
{
    if (is_given(source, "solver.kinematics") && solver.kinematics == dem::Kinematics::small)
        throw error_at(source, "solver.kinematics",
                       "a wall that is shaken turns by any amount; write finite, or remove it");
    if (masonry.wall.toe == dem::Toe::held && masonry.wall.base == dem::Base::joint &&
        in_courses(masonry.geometry))
        throw error_at(source, "wall.toe",
                       "is held sideways, and the blocks of a wall that is shaken are held "
                       "altogether or not at all; write toe = free");
    if (shaking.contact_damping > 0.0 && closes(masonry.parameters.joint))
        throw error_at(source, "shaking.contact_damping",
                       "joints that close have no dashpots, they lose energy by "
                       "joint.closure_loss; write 0, or remove joint.closure");
}

Study moving_study(Study study)
{
    study.load.pattern = dem::LoadPattern::body;
    return study;
}

} // namespace app
