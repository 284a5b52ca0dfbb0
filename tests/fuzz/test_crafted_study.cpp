#include "app/input/prepared_study.hpp"
#include "app/input/study_reading.hpp"
#include "fuzz/crafted_hdf5.hpp"

#include "app/child_process.hpp"
#include "app/store/hdf5/store_error.hpp"
#include "app/study/run_study.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/config_error.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

fs::path whole_study(const fs::path& folder)
{
    const std::vector<std::string> set = {"uq.samples=2", "solver.fidelity=rigid",
                                          "load.max_displacement=1 mm"};
    app::StudyRun run;
    run.file = folder / "whole.h5";
    run.threads = 1;
    static_cast<void>(app::run_study(
        app::prepare(
            app::prepare(app::read_study(DRYSTONE_SOURCE_DIR "/tests/study/small.ini", set))
                .study),
        run));
    return run.file;
}

/// The fault in how a crafted file was refused; empty if it was read or refused by its name.
std::string wrong_refusal(const fs::path& file)
{
    std::string words;
    try {
        static_cast<void>(app::read_study_walls(file, {}, app::Keep::everything));
        return "";
    } catch (const app::StoreError& error) {
        words = error.what();
    } catch (const app::ConfigError& error) {
        words = error.what();
    } catch (const std::exception& error) {
        return error.what();
    }
    return words.find(file.string()) == std::string::npos ? words : "";
}

} // namespace

TEST_CASE("fuzz: a crafted file of a study is read whole or refused by its name",
          "[fuzz][study_walls]")
{
    const scenes::TemporaryFolder folder;
    const fs::path whole = whole_study(folder.path), file = folder.path / "a.h5";
    REQUIRE(wrong_refusal(whole).empty());
    const pid_t child = scenes::start_child([&] {
        int wrong = 0;
        for (std::uint64_t k = 0; k < 200; ++k) {
            uq::Stream random(1, k, uq::Purpose::search);
            fs::copy_file(whole, file, fs::copy_options::overwrite_existing);
            const std::string what = crafted::change_anything(file, random);
            ::alarm(20);
            const std::string said = wrong_refusal(file);
            if (said.empty()) continue;
            std::fprintf(stderr, "%s: %s\n", what.c_str(), said.c_str());
            ++wrong;
        }
        return wrong == 0 ? 0 : 2;
    });
    CHECK(scenes::wait_for(child) == 0);
}
