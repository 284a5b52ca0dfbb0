#include "app/commands.hpp"

#include "app/output/picture/markup.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/table_files.hpp"
#include "app/study/answers/fragility_text.hpp"
#include "app/study/stored/study_file_head.hpp"
#include "app/surrogate/surrogate_output.hpp"

#include <iostream>

namespace app {
namespace {

std::string picture_name(const LevelSurrogate& l)
{
    return "predicted_" + file_name(stress_text(l.points.stress)) + ".svg";
}

std::vector<OutputFile> surrogate_files(const SurrogateStudy& s)
{
    std::vector<OutputFile> files = {{"surrogate.json", surrogate_json(s)}};
    add_table(files, "surrogate", surrogate_table(s));
    add_table(files, "indices", surrogate_index_table(s));
    add_table(files, "modes", surrogate_mode_table(s));
    add_table(files, "walls", surrogate_wall_table(s));
    for (const LevelSurrogate& l : s.levels)
        if (l.left_out.size() > 0) files.push_back({picture_name(l), surrogate_picture(s, l)});
    return files;
}

} // namespace

int surrogate_command(const Command& command)
{
    const WallNumber& response =
        surrogate_response(command.of.empty() ? kWallNumbers.front().name : command.of);
    check_is_study(command.study);
    if (const std::string note =
            check_results(command.out, {"surrogate.json", "surrogate.csv"});
        !command.quiet)
        std::cerr << note;
    const StudyWalls walls = read_study_walls(command.study, {}, Keep::means);
    const SurrogateStudy s = surrogate_study(walls, response);
    write_results(command.out, surrogate_files(s));
    const std::size_t width = terminal_width();
    for (const Table& t :
         {surrogate_table(s), surrogate_index_table(s), surrogate_mode_table(s)})
        std::cout << t.title << "\n" << as_text(t, width) << "\n";
    std::cout << wrapped(surrogate_remarks(s), width) << "written to " << command.out
              << (predicts(s) ? "; surrogate.json there predicts walls that were never run\n"
                              : "; surrogate.json there predicts no wall: see above\n");
    return 0;
}

} // namespace app
