#include "app/commands.hpp"

#include "app/output/atomic_output.hpp"
#include "app/output/replaced_file.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/study_file_head.hpp"
#include "app/text/number_text.hpp"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string_view>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr int kDigits = 9; // as capacity.csv
constexpr std::string_view kColumns =
    "level,vertical_stress_MPa,sample,displacement_mm,force_kN";

void write_wall(std::ostream& out, const StoreHead& head, const WallRow& row)
{
    const std::string key = std::to_string(row.key.level) + ',' +
                            number(head.levels[row.key.level].vertical_stress / 1e6, 12) + ',' +
                            std::to_string(row.key.sample) + ',';
    for (std::size_t i = 0; i < row.curve.displacement.size(); ++i)
        out << key << number(row.curve.displacement[i] * 1e3, kDigits) << ','
            << number(row.curve.force[i] * 1e-3, kDigits) << '\n';
}

} // namespace

int curves_command(const Command& command)
{
    check_is_study(command.study);
    if (const std::string note = check_replaced(command.out, kColumns); !command.quiet)
        std::cerr << note;
    StoreReader reader(command.study);
    const fs::path file = command.out, part = command.out + ".part";
    if (file.has_parent_path()) make_folder(file.parent_path());
    std::ofstream out(part, std::ios::binary);
    out << kColumns << '\n';
    std::size_t walls = 0;
    reader.for_each_row([&](const WallRow& row) {
        write_wall(out, reader.head(), row);
        walls += row.curve.force.empty() ? 0 : 1;
    });
    out.close();
    if (!out) {
        fs::remove(part);
        throw std::runtime_error(file.string() + ": cannot be written; is the disk full?");
    }
    fs::rename(part, file);
    std::cout << walls << " curves written to " << file.string() << '\n';
    return 0;
}

} // namespace app
