#include "app/input/key_effects.hpp"
#include "app/input/push_cost.hpp"
#include "app/input/study_reading.hpp"
#include "app/input/wall/wall_geometry.hpp"
#include "app/text/number_text.hpp"
#include "dem/block/build_cost.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace app {

namespace {

/// The memory that this process may have [bytes].
double memory()
{
    const double whole = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                         static_cast<double>(sysconf(_SC_PAGE_SIZE));
    rlimit allowed{};
    if (getrlimit(RLIMIT_AS, &allowed) != 0 || allowed.rlim_cur == RLIM_INFINITY) return whole;
    return std::min(whole, static_cast<double>(allowed.rlim_cur));
}

std::string gigabytes(double bytes) { return fixed(std::max(bytes, 1e8) / 1e9, 1) + " GB"; }

constexpr double kMinute = 60.0; // [s]

std::string time_text(double seconds)
{
    return seconds < kMinute ? fixed(std::max(seconds, 1.0), 0) + " s"
                             : fixed(seconds / kMinute, 0) + " min";
}

/// Values that make blocks and contacts fewer.
std::string what_costs_less(const GeometryInput& geometry, bool beam)
{
    if (beam) return "a beam that is less high, longer units or fewer solver.contact_points";
    if (geometry.file.ends_with(".png"))
        return "a larger wall.simplify or fewer solver.contact_points";
    return "fewer solver.contact_points or solver.zones_per_interval, or units with a larger "
           "length-to-height ratio";
}

} // namespace

std::string push_note(const PreparedStudy& ready)
{
    constexpr double kLong = 30.0; // [s]
    const double updates = expected_updates(ready.study.load, ready.study.discretisation,
                                            ready.study.solver, ready.layout),
                 seconds = updates / kUpdatesPerSecond;
    if (seconds < kLong) return "";
    return "note: a push to its end takes about " + time_text(seconds) +
           " of a core, less where its limits are known before, more where it has to be "
           "repeated more slowly (solver.accuracy); " +
           what_costs_less(ready.study.geometry, false) + " cost less\n";
}

std::string cost_note(const PreparedStudy& ready, Purpose purpose)
{
    const Study& study = ready.study;
    constexpr double kSeconds = 10.0, kBytes = 1e9;
    const dem::BuildCost c = dem::build_cost(ready.layout, study.discretisation);
    const std::string text = "about " + time_text(c.seconds) + " and " + gigabytes(c.bytes);
    const bool beam = c.beam && study.beam.height > wall_length(study);
    const std::string less = what_costs_less(study.geometry, beam) + " cost less";
    const double available = memory();
    if (c.bytes > available && purpose == Purpose::push)
        throw error_at(study.source, beam ? "beam.height" : "solver.contact_points",
                       std::string(beam ? "the beam" : "the blocks") + " would take " + text +
                           " before the push begins, more than the " + gigabytes(available) +
                           " there are; " + less);
    if (c.seconds < kSeconds && c.bytes < kBytes) return "";
    return "note: making the blocks takes " + text + " before the push begins; " + less + "\n";
}

} // namespace app
