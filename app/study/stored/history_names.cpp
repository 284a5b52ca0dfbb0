#include "app/study/stored/history_names.hpp"

#include "app/store/hdf5/store_error.hpp"

#include <algorithm>
#include <sstream>

namespace app {

bool holds_histories(const StoreHead& head)
{
    return std::ranges::find(head.counts, kRecordColumn, &Column::name) != head.counts.end();
}

std::vector<std::string> record_lines(const std::string& identity)
{
    std::vector<std::string> lines;
    std::istringstream in(identity);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(kRecordLine)) lines.push_back(line);
    return lines;
}

std::string without_record_lines(const std::string& identity)
{
    std::string text;
    std::istringstream in(identity);
    for (std::string line; std::getline(in, line);)
        if (!line.starts_with(kRecordLine)) text += line + "\n";
    return text;
}

std::string record_name(std::string_view line)
{
    const std::size_t begin = line.find(" = "), end = line.rfind("; sum ");
    if (begin == std::string_view::npos || end == std::string_view::npos || end < begin + 3)
        return std::string(line);
    return std::string(line.substr(begin + 3, end - begin - 3));
}

void refuse_histories(const std::string& file, const StoreHead& head)
{
    if (holds_histories(head))
        throw BadStoredStudy("'" + file +
                             "' holds histories of walls that were shaken, and no pushes; "
                             "write \"drystone fragility " +
                             file + "\" for their fragility");
}

} // namespace app
