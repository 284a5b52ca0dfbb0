#include "app/study/slurm_command.hpp"

#include "scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>
#include <string>

namespace {

/// The script for a study of this work, on one thread.
std::string script(const app::StudyWork& work)
{
    const scenes::TemporaryFolder folder;
    app::Command command;
    command.study = "study.ini";
    command.out = (folder.path / "study.h5").string();
    command.script = (folder.path / "study.sh").string();
    command.threads = 1;
    command.quiet = true;
    CHECK(app::write_slurm_script(work, command) == 0);
    std::ifstream in(folder.path / "study.sh");
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

TEST_CASE("slurm command: shards of half an hour, with twice their time and a quarter more",
          "[app][slurm]")
{
    const std::string plain = script({3600, "histories", 1.0, 3600.0, 0, 0.0});
    CHECK_THAT(plain, Catch::Contains("\nshards=2\n") && Catch::Contains("\nminutes=75\n"));
}

TEST_CASE("slurm command: each shard pushes the walls whose histories it has", "[app][slurm]")
{
    // ten walls, 360 histories of each: every shard pushes all ten, which takes ten minutes
    const app::StudyWork work{3600, "histories", 1.0, 3600.0, 10, 60.0};
    CHECK(app::seconds_of(work, 3) == 3600.0 + 3 * 600.0);
    CHECK_THAT(script(work),
               Catch::Contains("\nshards=3\n") && Catch::Contains("\nminutes=75\n"));
    // one history of each wall: each is pushed once, wherever it is
    CHECK(app::seconds_of({10, "histories", 1.0, 10.0, 10, 60.0}, 3) == 610.0);
    CHECK(app::pushes_of({20, "histories", 1.0, 20.0, 10, 60.0}, 8) == 20.0);
}
