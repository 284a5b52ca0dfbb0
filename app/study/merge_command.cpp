#include "app/commands.hpp"

#include "app/output/atomic_output.hpp"
#include "app/output/picture/markup.hpp"
#include "app/store/merge.hpp"
#include "app/store/store_reader.hpp"
#include "app/study/stored/history_names.hpp"
#include "app/study/stored/history_summary.hpp"
#include "app/study/study_summary.hpp"

#include <filesystem>
#include <iostream>

namespace app {

int merge_command(const Command& command)
{
    const std::filesystem::path out = command.words.front();
    const std::vector<std::filesystem::path> shards(command.words.begin() + 1,
                                                    command.words.end());
    const bool shaken = holds_histories(read_head(shards.front()));
    const WallCheck check = shaken ? WallCheck() : readable_walls(shards.front());
    if (out.has_parent_path()) make_folder(out.parent_path());
    merge(out, shards, command.partial, check);
    if (shaken) {
        const HistorySummary summary = history_summary(read_histories(out));
        std::cout << as_text(summary.table, terminal_width())
                  << wrapped(summary.remarks, terminal_width()) << "written to " << out.string()
                  << '\n';
        return summary.failed == 0 ? 0 : 1;
    }
    const StudySummary summary = summarise(read_study_walls(out, {}, Keep::readings));
    std::cout << as_text(summary.table, terminal_width())
              << wrapped(summary.remarks, terminal_width()) << "written to " << out.string()
              << '\n';
    return summary.failed == 0 ? 0 : 1; // walls that are missing were asked for
}

} // namespace app
