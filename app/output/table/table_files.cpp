#include "app/output/table/table_files.hpp"

namespace app {

std::array<OutputFile, 3> table_files(const std::string& stem, const Table& table)
{
    return {OutputFile{stem + kTableEndings[0], as_csv(table)},
            {stem + kTableEndings[1], as_markdown(table)},
            {stem + kTableEndings[2], as_latex(table)}};
}

void add_table(std::vector<OutputFile>& files, const std::string& stem, const Table& table)
{
    for (const OutputFile& f : table_files(stem, table)) files.push_back(f);
}

} // namespace app
