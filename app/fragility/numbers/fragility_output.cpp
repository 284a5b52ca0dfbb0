#include "app/fragility/numbers/fragility_output.hpp"

#include "app/output/picture/markup.hpp"
#include "app/output/table/table_files.hpp"
#include "app/output/unique_names.hpp"
#include "app/program_version.hpp"
#include "app/text/json_text.hpp"

#include <algorithm>
#include <numeric>
#include <sstream>

namespace app {
namespace {

namespace fs = std::filesystem;

Json cell_json(const PlainTable::Value& cell)
{
    if (const auto* const text = std::get_if<std::string>(&cell)) return *text;
    const auto* const value = std::get_if<double>(&cell);
    return value ? Json(*value) : Json(nullptr);
}

Json table_json(const NamedTable& named)
{
    const PlainTable table = plain(named.table);
    Json rows = Json::array();
    for (const auto& row : table.rows) {
        Json object = Json::object();
        for (std::size_t c = 0; c < row.size(); ++c) object[table.head[c]] = cell_json(row[c]);
        rows.push_back(std::move(object));
    }
    return {{"title", named.table.title}, {"caption", named.table.caption}, {"rows", rows}};
}

std::string path_of(const NamedTable& t) { return (t.answer ? "" : "tables/") + t.name; }

std::string link(const std::string& path, const std::string& title)
{
    return "- [" + path + "](" + path + "): " + markdown_text(title) + "\n";
}

std::string readme(const FragilityOutput& output)
{
    std::string text = "# Fragility: " + markdown_text(output.source) + "\n\n";
    std::istringstream remarks(output.remarks);
    for (std::string line; std::getline(remarks, line);)
        text += "- " + markdown_text(line) + "\n";
    if (!output.remarks.empty()) text += "\n";
    for (const NamedTable& t : output.tables)
        if (t.answer) text += "## " + as_markdown(t.table) + "\n";
    text += "## Files\n\nEach table is there as `.md` with its caption, as `.tex` (booktabs, "
            "graphicx, "
            "longtable) and as `.csv` with all digits, one number per column.\n\n";
    for (const NamedTable& t : output.tables) text += link(path_of(t) + ".md", t.table.title);
    text += link("fragility.json", "all tables with all digits, as one object");
    if (!output.pelicun.empty())
        text += link("pelicun_fragility.csv",
                     "parameters for pelicun; Incomplete is 1 where no law could be fitted");
    if (!output.openquake.empty())
        text += link("openquake_fragility.xml", "fragility model for the OpenQuake engine");
    for (const NamedPicture& p : output.pictures)
        text += link("pictures/" + p.name + ".svg", p.title);
    return text;
}

} // namespace

std::string fragility_json(const FragilityOutput& output)
{
    Json tables = Json::object();
    for (const NamedTable& t : output.tables) tables[t.name] = table_json(t);
    const Json all = {{"source", output.source},
                      {"version", program_version()},
                      {"remarks", output.remarks},
                      {"tables", tables}};
    return text_of(all, 1) + "\n";
}

Table short_table(const NamedTable& named)
{
    const Table& all = named.table;
    std::vector<std::size_t> rows = named.main;
    if (all.rows.size() <= kShortRows) {
        rows.resize(all.rows.size());
        std::iota(rows.begin(), rows.end(), std::size_t{0});
    }
    rows.resize(std::min(rows.size(), kShortRows));
    Table t{.caption = all.caption,
            .head = all.head,
            .rows = {},
            .title = all.title,
            .keys = all.keys};
    for (const std::size_t r : rows) t.rows.push_back(all.rows[r]);
    return without_details(t);
}

void make_names_unique(FragilityOutput& output)
{
    UniqueNames tables, pictures;
    for (NamedTable& t : output.tables) t.name = tables.add(t.name);
    for (NamedPicture& p : output.pictures) p.name = pictures.add(p.name);
}

std::size_t write_output(const fs::path& folder, const FragilityOutput& output)
{
    std::vector<OutputFile> files = {{"fragility.json", fragility_json(output)}};
    if (!output.pelicun.empty()) files.push_back({"pelicun_fragility.csv", output.pelicun});
    if (!output.openquake.empty())
        files.push_back({"openquake_fragility.xml", output.openquake});
    for (const NamedTable& t : output.tables) add_table(files, path_of(t), t.table);
    for (const NamedPicture& p : output.pictures)
        files.push_back({"pictures/" + p.name + ".svg", p.svg});
    files.push_back({"README.md", readme(output)}); // the last: what it lists is there
    return write_results(folder, files);
}

} // namespace app
