/// The walls of the program that is built first: it knows study files, but neither designs nor
/// files of results.
#include "app/input/study_reading.hpp"
#include "app/study/wanted_walls.hpp"

#include <utility>

namespace app {
namespace {

[[noreturn]] void refuse(const std::string& what)
{
    throw ConfigError("drystone", 0, what,
                      "takes the whole program, and this one pushes the walls of study files "
                      "alone; run it by ./drystone, which builds the other");
}

} // namespace

StudySource study_source(const std::string& path, std::span<const std::string> overrides,
                         Purpose purpose)
{
    if (path.ends_with(".h5")) refuse(path);
    return {prepare(read_study(path, overrides, purpose)), {}, {}};
}

std::vector<WantedWall> wanted_walls(const StudySource& source, const WallChoice& choice)
{
    if (choice.sample) refuse("--sample");
    return numbered_walls(source.ready, choice);
}

} // namespace app
