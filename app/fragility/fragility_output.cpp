#include "app/fragility/fragility_output.hpp"

#include "app/output/atomic_output.hpp"
#include "app/version.hpp"

#include <nlohmann/json.hpp>

namespace app {
namespace {

using Json = nlohmann::ordered_json;
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

std::string index_text(const FragilityOutput& output)
{
    std::string text = "# Fragility: " + output.source + "\n\n";
    if (!output.remarks.empty()) text += output.remarks + "\n";
    text += "Each table is there as `.md` (with its caption), `.tex` and `.csv` (all digits, "
            "one number "
            "per column).\n\n| file | what it is |\n|:--|:--|\n";
    for (const NamedTable& t : output.tables)
        text += "| [" + t.name + "](" + t.name + ".md) | " + t.table.title + " |\n";
    for (const NamedPicture& p : output.pictures)
        text += "| [" + p.name + ".svg](" + p.name + ".svg) | " + p.title + " |\n";
    text += "| [fragility.json](fragility.json) | everything in the tables, as one object |\n";
    text += "| [pelicun_fragility.csv](pelicun_fragility.csv) | damage model parameters for "
            "pelicun; incomplete where no law could be fitted |\n";
    return text;
}

} // namespace

std::string fragility_json(const FragilityOutput& output)
{
    Json tables = Json::object();
    for (const NamedTable& t : output.tables) tables[t.name] = table_json(t);
    const Json all = {{"source", output.source},
                      {"version", std::string(kVersion)},
                      {"remarks", output.remarks},
                      {"tables", tables}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_output(const fs::path& folder, const FragilityOutput& output)
{
    make_folder(folder);
    for (const NamedTable& t : output.tables) {
        write_file(folder / (t.name + ".csv"), as_csv(t.table));
        write_file(folder / (t.name + ".md"), as_markdown(t.table));
        write_file(folder / (t.name + ".tex"), as_latex(t.table));
    }
    for (const NamedPicture& p : output.pictures) write_file(folder / (p.name + ".svg"), p.svg);
    write_file(folder / "fragility.json", fragility_json(output));
    write_file(folder / "pelicun_fragility.csv", output.pelicun);
    write_file(folder / "README.md", index_text(output));
}

} // namespace app
