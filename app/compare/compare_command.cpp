#include "app/compare/compare_command.hpp"

#include "app/compare/compared.hpp"
#include "app/compare/compared_cycles.hpp"
#include "app/compare/compared_limits.hpp"
#include "app/output/picture/markup.hpp"
#include "app/output/picture/svg_elements.hpp"
#include "app/output/result_folder.hpp"
#include "app/output/table/table_files.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace app {
namespace {

constexpr std::string_view kCompareList = "drystone_compare_files.txt";

std::string html_table(const Table& table)
{
    const ShownTable t = shown(table);
    std::string body = "<table>\n<tr>";
    for (const std::string& h : t.head) body += "<th>" + xml_escape(h) + "</th>";
    for (const std::vector<std::string>& row : t.rows) {
        body += "</tr>\n<tr>";
        for (const std::string& cell : row) body += "<td>" + xml_escape(cell) + "</td>";
    }
    return body + "</tr>\n</table>\n";
}

/// A table with its chart, if it has one, before it.
struct Part {
    std::string name; ///< of its files
    Table table;
    std::string chart;
};

std::string page(const std::vector<Part>& parts)
{
    std::string body;
    for (const Part& p : parts)
        body += "<h1>" + xml_escape(p.table.title) + "</h1>\n" + p.chart + "<div>\n" +
                html_table(p.table) + "</div>\n<p>" + xml_escape(p.table.caption) + "</p>\n";
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
           "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
           "<title>Walls side by side</title>\n<style>\n"
           "body { font: 15px/1.4 sans-serif; max-width: 1100px; margin: 1em auto; padding: 0 "
           "1em; color: #222 }\n"
           "div { overflow-x: auto }\ntable { border-collapse: collapse }\n"
           "th, td { text-align: left; padding: 3px 10px 3px 0; border-bottom: 1px solid #ccc; "
           "white-space: nowrap }\n"
           "svg { max-width: 100%; height: auto }\np { color: #555 "
           "}\n</style>\n</head>\n<body>\n" +
           body + "</body>\n</html>\n";
}

/// All that one word of the command names.
struct ReadFrom {
    std::string path;
    std::vector<Compared> walls;
    std::vector<ComparedLimit> limits;
};

/// Two files or folders of one name stand with their paths: "a/wall" and "b/wall".
std::vector<ReadFrom> told_apart(std::vector<ReadFrom> all)
{
    std::map<std::string, std::set<std::string>> paths; // by name
    const auto each = [&](auto&& work) {
        for (ReadFrom& r : all) {
            for (Compared& c : r.walls) work(c.name, r.path);
            for (ComparedLimit& l : r.limits) work(l.name, r.path);
        }
    };
    each([&](const std::string& name, const std::string& path) { paths[name].insert(path); });
    const auto shared = paths;
    each([&](std::string& name, const std::string& path) {
        if (shared.at(name).size() > 1) name = path;
    });
    return all;
}

} // namespace

int compare_command(const Command& command)
{
    std::vector<std::filesystem::path> names = {"compare.svg", "limits.svg", "compare.html"};
    for (const char* const ending : kTableEndings)
        for (const char* const name : {"compare", "cycles", "limits"})
            names.push_back(std::string(name) + ending);
    if (const std::string note = check_results(command.out, names, kCompareList);
        !command.quiet)
        std::cerr << note;
    std::vector<Compared> all;
    std::vector<ComparedLimit> limits;
    std::vector<ReadFrom> read;
    for (const std::string& path : command.words)
        read.push_back({path, read_compared(path), read_limits(path)});
    for (ReadFrom& r : told_apart(std::move(read))) {
        for (const Compared& c : r.walls)
            if (!c.note.empty())
                std::cerr << wrapped("note: " + r.path + ": " + c.note + ".\n",
                                     terminal_width());
        std::ranges::move(r.walls, std::back_inserter(all));
        std::ranges::move(r.limits, std::back_inserter(limits));
    }
    std::vector<Part> parts;
    if (!all.empty()) parts.push_back({"compare", compared_table(all), compared_chart(all)});
    if (Table cycles = compared_cycle_table(all); !cycles.rows.empty())
        parts.push_back({"cycles", std::move(cycles), ""});
    if (!limits.empty())
        parts.push_back({"limits", compared_limit_table(limits), compared_limit_chart(limits)});
    std::vector<OutputFile> files;
    for (const Part& p : parts) {
        add_table(files, p.name, p.table);
        if (!p.chart.empty()) files.push_back({p.name + ".svg", p.chart});
        std::cout << (&p == &parts.front() ? "" : "\n" + p.table.title + "\n")
                  << as_text(p.table, terminal_width());
    }
    for (const Compared& c : all)
        if (const std::string key = targets_along(c); !key.empty())
            std::cout << wrapped("to push a wall as " + c.name + ": " + key + "\n",
                                 terminal_width());
    files.push_back({"compare.html", page(parts)});
    write_results(command.out, files, kCompareList);
    std::cout << "written to " << command.out << '\n';
    return 0;
}

} // namespace app
