/// The walls of the program that is built first: it knows study files, but neither designs nor
/// files of results.
#include "app/input/study_name.hpp"
#include "app/input/study_reading.hpp"
#include "app/study/stored/wanted_walls.hpp"

#include <utility>

namespace app {
namespace {

[[noreturn]] void refuse(const std::string& what)
{
    throw ConfigError("drystone", 0, what,
                      "needs the whole program. This one is built for a first push and knows "
                      "study files alone; run ./drystone from the checkout, which builds the "
                      "other");
}

} // namespace

StudySource study_source(const std::string& path, std::span<const std::string> overrides,
                         Purpose purpose)
{
    if (is_study_name(path)) refuse(path);
    return {prepare(read_study(path, overrides, purpose)), {}, {}};
}

std::vector<WantedWall> wanted_walls(const StudySource& source, const WallChoice& choice)
{
    if (choice.sample) refuse("--sample");
    return numbered_walls(source.ready, choice);
}

} // namespace app
