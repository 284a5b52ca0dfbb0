#include "app/output/table.hpp"

#include <catch2/catch.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace {

app::Table mode_table()
{
    return {"Mode of failure",
            {"stress [MPa]", "peak [kN]", "mode"},
            {{"0.15", "16.2", "rocking"}, {"1.25", "", "mixed"}}};
}

std::vector<std::string> lines(const std::string& text)
{
    std::vector<std::string> all;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
}

std::string only_cell_as_csv(const std::string& cell)
{
    return lines(app::as_csv({"", {"head"}, {{cell}}})).at(1);
}

std::string only_cell_as_latex(const std::string& cell)
{
    const std::string text = app::as_latex({"", {"head"}, {{cell}}});
    const std::size_t from = text.find("\\midrule\n") + 9;
    return text.substr(from, text.find(" \\\\\n", from) - from);
}

} // namespace

TEST_CASE("table: as text its columns are aligned on the right", "[app][table]")
{
    CHECK(app::as_text(mode_table()) == "stress [MPa]  peak [kN]     mode\n"
                                        "        0.15       16.2  rocking\n"
                                        "        1.25               mixed\n");
}

TEST_CASE("table: signs of several bytes take one column", "[app][table]")
{
    const app::Table t{"", {"φ [°]", "σ²"}, {{"30", "1"}, {"µ ± δ", "2"}}};
    CHECK(app::as_text(t) == "φ [°]  σ²\n"
                             "   30   1\n"
                             "µ ± δ   2\n");
}

TEST_CASE("table: as CSV every row has the cells of the head, empty where not defined",
          "[app][table]")
{
    CHECK(app::as_csv(mode_table()) == "stress [MPa],peak [kN],mode\n"
                                       "0.15,16.2,rocking\n"
                                       "1.25,,mixed\n");
}

TEST_CASE("table: CSV cells that a reader would cut are quoted", "[app][table]")
{
    CHECK(only_cell_as_csv("0.15, 0.50") == "\"0.15, 0.50\"");
    CHECK(only_cell_as_csv("the \"mixed\" mode") == "\"the \"\"mixed\"\" mode\"");
    CHECK(app::as_csv({"", {"a"}, {{"two\nlines"}}}) == "a\n\"two\nlines\"\n");
    CHECK(only_cell_as_csv("0.15 MPa") == "0.15 MPa");
    CHECK(app::as_csv({"", {"force, kN", "b"}, {}}) == "\"force, kN\",b\n"); // the head too
}

TEST_CASE(
    "table: as Markdown it has a caption, a rule that aligns to the right, and equal columns",
    "[app][table]")
{
    CHECK(app::as_markdown(mode_table()) == "Mode of failure\n"
                                            "\n"
                                            "| stress [MPa] | peak [kN] |    mode |\n"
                                            "|-------------:|----------:|--------:|\n"
                                            "|         0.15 |      16.2 | rocking |\n"
                                            "|         1.25 |           |   mixed |\n");
    app::Table bare = mode_table();
    bare.caption.clear();
    CHECK(app::as_markdown(bare).rfind("| stress", 0) == 0);
}

TEST_CASE("table: a bar in a cell does not open a column of Markdown", "[app][table]")
{
    const app::Table t{"", {"|V - R| [kN]"}, {{"1"}}};
    const std::string head = lines(app::as_markdown(t)).at(0);
    int bars = 0;
    for (std::size_t i = 0; i < head.size(); ++i)
        bars += head[i] == '|' && (i == 0 || head[i - 1] != '\\');
    CHECK(bars == 2);
}

TEST_CASE("table: as LaTeX it is an environment with booktabs rules", "[app][table]")
{
    CHECK(app::as_latex(mode_table()) == "\\begin{table}\n"
                                         "\\centering\n"
                                         "\\caption{Mode of failure}\n"
                                         "\\begin{tabular}{rrr}\n"
                                         "\\toprule\n"
                                         "stress [MPa] & peak [kN] & mode \\\\\n"
                                         "\\midrule\n"
                                         "0.15 & 16.2 & rocking \\\\\n"
                                         "1.25 &  & mixed \\\\\n"
                                         "\\bottomrule\n"
                                         "\\end{tabular}\n"
                                         "\\end{table}\n");
}

TEST_CASE("table: what LaTeX would obey is written as it reads", "[app][table]")
{
    CHECK(only_cell_as_latex("80 % & $1 #2 k_n {a}") == "80 \\% \\& \\$1 \\#2 k\\_n \\{a\\}");
    CHECK(only_cell_as_latex("> 0.25") == "$>$ 0.25");
    CHECK(only_cell_as_latex("a < b") == "a $<$ b");
    CHECK(app::as_latex({"100 %", {"k_n"}, {}}).find("\\caption{100 \\%}") !=
          std::string::npos);
    CHECK(app::as_latex({"", {"k_n"}, {}}).find("k\\_n \\\\") != std::string::npos);
}

TEST_CASE("table: signs that LaTeX reads as accents or commands do not break it",
          "[app][table]")
{
    CHECK(only_cell_as_latex("N/m^2") == "N/m\\textasciicircum{}2");
    CHECK(only_cell_as_latex("~30 mm") == "\\textasciitilde{}30 mm");
    CHECK(only_cell_as_latex("C:\\runs") == "C:\\textbackslash{}runs");
}

TEST_CASE("table: without rows only the head is left", "[app][table]")
{
    const app::Table t{"", {"a", "bc"}, {}};
    CHECK(app::as_text(t) == "a  bc\n");
    CHECK(app::as_csv(t) == "a,bc\n");
    CHECK(app::as_markdown(t) == "| a | bc |\n|--:|---:|\n");
}
