/// default_push WORK OUT.md: a push to the limits beside one with small displacements, from the
/// studies of bench/default_push.sh.

#include "app/store/store_reader.hpp"
#include "app/study/stored/study_walls.hpp"
#include "app/text/number_text.hpp"
#include "bench/limit_drifts.hpp"
#include "bench/report.hpp"

#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <string>

namespace {

/// Mean processor time of a wall of each stress [s].
std::map<std::uint32_t, double> seconds_by_level(const std::filesystem::path& file)
{
    std::map<std::uint32_t, double> sum, n;
    app::StoreReader(file).for_each_row([&](const app::WallRow& row) {
        sum[row.key.level] += row.cost.front();
        n[row.key.level] += 1.0;
    });
    for (auto& [level, seconds] : sum) seconds /= n[level];
    return sum;
}

void write(const std::filesystem::path& work, const std::string& out)
{
    struct Push {
        const char* file;
        const char* name;
    };
    constexpr Push kPushes[] = {
        {"small.h5", "small displacements, to 30 mm"},
        {"default.h5", "the defaults: finite, until the limits are known"}};
    app::Table t;
    t.head = bench::limit_head();
    t.head.emplace_back("time of a wall [s]");
    const std::string walls =
        std::to_string(app::read_study_walls(work / "small.h5").levels.front().walls.size());
    for (std::uint32_t level = 0; level < 5; ++level)
        for (const Push& push : kPushes) {
            const std::filesystem::path file = work / push.file;
            app::Row row = bench::limit_row(push.name, app::read_study_walls(file), level);
            row.emplace_back(app::fixed(seconds_by_level(file).at(level), 2));
            t.rows.push_back(std::move(row));
        }
    bench::write_report(
        out, {"Cost and effect of the default push",
              "The walls of `configs/paper.ini`, " + walls +
                  " under each stress, with simple stones and the default damping. They are "
                  "pushed twice: with small displacements to 30 mm, as in that file; and "
                  "without these two keys, that is with finite displacements until the force "
                  "is down to 78 % of its peak, at most a fifth of the height. By `bash "
                  "bench/default_push.sh`. Drifts by "
                  "Kaplan and Meier with 95 % intervals; time: of one processor.",
              {{"", "", "", t}}});
}

} // namespace

int main(int argc, char** argv)
try {
    if (argc != 3) {
        std::cerr << "usage: default_push WORK OUT.md\n";
        return 2;
    }
    write(argv[1], argv[2]);
    return 0;
} catch (const std::exception& e) {
    std::cerr << "default_push: " << e.what() << '\n';
    return 1;
}
