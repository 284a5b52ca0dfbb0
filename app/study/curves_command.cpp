#include "app/commands.hpp"

#include "app/output/atomic_output.hpp"
#include "app/output/replaced_file.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/text/number_text.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr int kDigits = 9; // as capacity.csv
constexpr std::string_view kColumns =
    "level,vertical_stress_MPa,sample,displacement_mm,force_kN";

/// Points without a number, as a wall that failed may end, are left out.
std::string wall_lines(const StoreHead& head, const WallRow& row)
{
    const std::string key = std::to_string(row.key.level) + ',' +
                            number(head.levels[row.key.level].vertical_stress / 1e6, 12) + ',' +
                            std::to_string(row.key.sample) + ',';
    std::string lines;
    for (std::size_t i = 0; i < row.curve.displacement.size(); ++i) {
        const double u = row.curve.displacement[i], f = row.curve.force[i];
        if (std::isfinite(u) && std::isfinite(f))
            lines += key + number(u * 1e3, kDigits) + ',' + number(f * 1e-3, kDigits) + '\n';
    }
    return lines;
}

} // namespace

int curves_command(const Command& command)
{
    check_is_study(command.study);
    if (const std::string note = check_replaced(command.out, kColumns); !command.quiet)
        std::cerr << note;
    StoreReader reader(command.study);
    refuse_histories(command.study, reader.head());
    const fs::path file = command.out;
    if (file.has_parent_path()) make_folder(file.parent_path());
    NewFile out(file);
    out.add(std::string(kColumns) + '\n');
    std::size_t walls = 0;
    reader.for_each_row([&](const WallRow& row) {
        out.add(wall_lines(reader.head(), row));
        walls += row.curve.force.empty() ? 0 : 1;
    });
    out.finish();
    if (const std::string other = other_revision_text(reader.head()); !other.empty())
        std::cout << other << '\n';
    std::cout << walls << " curves written to " << file.string() << '\n';
    return 0;
}

} // namespace app
