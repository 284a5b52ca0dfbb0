#include "app/output/picture/markup.hpp"
#include "app/output/table/cells.hpp"
#include "tests/app/fragility/latex_width.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace {

app::Table table(std::string caption, std::vector<app::Head> head, std::vector<app::Row> rows)
{
    app::Table t;
    t.caption = std::move(caption);
    t.head = std::move(head);
    t.rows = std::move(rows);
    return t;
}

app::Table mode_table()
{
    return table("Mode of failure", {"stress [MPa]", "peak [kN]", "mode"},
                 {{app::given(0.15), app::plain_number(16.234, 1), "rocking"},
                  {app::given(1.25), {}, "mixed"}});
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
    return lines(app::as_csv(table("", {"head"}, {{cell}}))).at(1);
}

std::string only_cell_as_latex(const std::string& cell)
{
    const std::string text = app::as_latex(table("", {"head"}, {{cell}}));
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
    const app::Table t = table("", {"φ [°]", "σ²"}, {{"30", "1"}, {"µ ± δ", "2"}});
    CHECK(app::as_text(t) == "φ [°]  σ²\n"
                             "   30   1\n"
                             "µ ± δ   2\n");
}

TEST_CASE("table: as CSV every row has the cells of the head, empty where not defined",
          "[app][table]")
{
    CHECK(app::as_csv(mode_table()) == "stress [MPa],peak [kN],mode\n"
                                       "0.15,16.234,rocking\n"
                                       "1.25,,mixed\n");
}

TEST_CASE("table: CSV cells that a reader would cut are quoted", "[app][table]")
{
    CHECK(only_cell_as_csv("0.15, 0.50") == "\"0.15, 0.50\"");
    CHECK(only_cell_as_csv("the \"mixed\" mode") == "\"the \"\"mixed\"\" mode\"");
    CHECK(app::as_csv(table("", {"a"}, {{"two\nlines"}})) == "a\n\"two\nlines\"\n");
    CHECK(only_cell_as_csv("0.15 MPa") == "0.15 MPa");
    CHECK(app::as_csv(table("", {"force, kN", "b"}, {})) ==
          "\"force, kN\",b\n"); // the head too
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
    const app::Table t = table("", {"|V - R| [kN]"}, {{"1"}});
    const std::string head = lines(app::as_markdown(t)).at(0);
    int bars = 0;
    for (std::size_t i = 0; i < head.size(); ++i)
        bars += head[i] == '|' && (i == 0 || head[i - 1] != '\\');
    CHECK(bars == 2);
}

TEST_CASE("table: as LaTeX it is an environment with booktabs rules, no wider than the page",
          "[app][table]")
{
    CHECK(app::as_latex(mode_table()) ==
          "\\begin{table}\n"
          "\\centering\n"
          "\\caption{Mode of failure}\n"
          "\\footnotesize\\setlength{\\tabcolsep}{4pt}\n"
          "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n"
          "\\begin{tabular}{rrr}\n"
          "\\toprule\n"
          "\\shortstack[r]{stress\\\\{}[MPa]} & peak [kN] & mode \\\\\n"
          "\\midrule\n"
          "0.15 & 16.2 & rocking \\\\\n"
          "1.25 &  & mixed \\\\\n"
          "\\bottomrule\n"
          "\\end{tabular}}\n"
          "\\end{table}\n");
}

TEST_CASE("table: with a title the caption of LaTeX is short, and the rest stands below",
          "[app][table]")
{
    app::Table t = mode_table();
    t.title = "Peaks";
    const std::string text = app::as_latex(t);
    CHECK(text.find("\\caption{Peaks}") != std::string::npos);
    CHECK(text.find("Mode of failure") > text.find("\\end{tabular}"));
    for (int i = 0; i < 60; ++i) t.rows.push_back(t.rows.front());
    CHECK(app::as_latex(t).find("\\begin{longtable}{rrr}") != std::string::npos);
}

TEST_CASE("table: one that a page of LaTeX does not take is parted into blocks with the keys",
          "[app][table]")
{
    app::Table t = table("", {"wall"}, {});
    const int columns = GENERATE(1, 9, 10, 40), rows = GENERATE(2, 50);
    for (int c = 0; c < columns; ++c)
        t.head.emplace_back("drift of wall number " + std::to_string(c) + " [%]");
    for (int r = 0; r < rows; ++r) {
        app::Row row = {"wall " + std::to_string(r)};
        for (int c = 0; c < columns; ++c) row.emplace_back("0.50 [0.45, 0.55]");
        t.rows.push_back(row);
    }
    const std::string text = app::as_latex(t);
    CHECK(scenes::widest_latex(text) <= scenes::kPagePoints);
    std::size_t captions = 0, keys = 0, heads = 0;
    for (std::size_t at = 0; (at = text.find("\\caption", at)) != std::string::npos; ++at)
        ++captions;
    for (std::size_t at = 0; (at = text.find("\nwall 1 & ", at)) != std::string::npos; ++at)
        ++keys;
    for (std::size_t at = 0; (at = text.find("\\toprule", at)) != std::string::npos; ++at)
        ++heads;
    CHECK(captions == 1);
    CHECK(keys == heads);
    CHECK(keys == static_cast<std::size_t>((columns + 4) / 5));
}

TEST_CASE("table: what LaTeX would obey is written as it reads", "[app][table]")
{
    CHECK(only_cell_as_latex("80 % & $1 #2 k_n {a}") == "80 \\% \\& \\$1 \\#2 k\\_n \\{a\\}");
    CHECK(only_cell_as_latex("> 0.25") == "$>$ 0.25");
    CHECK(only_cell_as_latex("a < b") == "a $<$ b");
    CHECK(app::as_latex(table("100 %", {"k_n"}, {})).find("\\caption{100 \\%}") !=
          std::string::npos);
    CHECK(app::as_latex(table("", {"k_n"}, {})).find("k\\_n \\\\") != std::string::npos);
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
    const app::Table t = table("", {"a", "bc"}, {});
    CHECK(app::as_text(t) == "a  bc\n");
    CHECK(app::as_csv(t) == "a,bc\n");
    CHECK(app::as_markdown(t) == "| a | bc |\n|--:|---:|\n");
}

namespace {

const double inf = std::numeric_limits<double>::infinity();

app::Table doubted(const app::Cell& cell, unsigned holds)
{
    return table("", {{"median [%]", holds}}, {{cell}});
}

} // namespace

TEST_CASE("table: people read a number with its doubt in one cell", "[app][table]")
{
    CHECK(app::cell_text(app::with_interval(1.576, 1.4, inf, 2)) == "1.58 [1.40, no limit]");
    CHECK(app::cell_text(app::with_interval(std::nan(""), 1.0, 2.0, 2)).empty());
    CHECK(app::cell_text(app::with_error(16.24, 0.31, 1)) == "16.2 +- 0.3");
    CHECK(app::cell_text(app::with_error(16.24, inf, 1)) == "16.2");
    CHECK(app::cell_text(app::range(0.0, 45.87, 1)) == "0.0 to 45.9");
    CHECK(app::cell_text(app::count(3)) == "3");
    CHECK(app::cell_text(app::given(0.4e6 * 1e-6)) == "0.4");
    CHECK(app::cell_text(app::Number{}).empty());
    // beyond 2.72 by more than an interval of 0.05 mm of 30 mm: marked
    CHECK(app::cell_text(app::with_interval(3.03, 1.97, 9.67, 2, 2.72)) ==
          "3.03† [1.97, 9.67†]");
    CHECK(app::cell_text(app::Number{.value = 2.725, .decimals = 3, .known_to = 2.72}) ==
          "2.725");
    CHECK(app::cell_text(app::Number{.value = 2.726, .decimals = 3, .known_to = 2.72}) ==
          "2.726†");
}

TEST_CASE("table: a lower bound is rounded down, and says whether it may be reached",
          "[app][table]")
{
    const auto bound = [](double x, int decimals, app::Sense sense) {
        return app::cell_text(app::Number{.lower = x, .decimals = decimals, .sense = sense});
    };
    CHECK(bound(2.7259, 2, app::Sense::above) == "> 2.72");
    CHECK(bound(0.29, 2, app::Sense::above) == "> 0.29");
    CHECK(bound(2.5, 1, app::Sense::at_least) == ">= 2.5");
    CHECK(app::cell_text(app::Number{
              .value = 79.979, .decimals = 2, .sense = app::Sense::above}) == "> 79.97");
}

TEST_CASE(
    "table: programs get fifteen digits, one number per column, and the same head whatever "
    "the rows hold",
    "[app][table]")
{
    CHECK(app::as_csv(doubted(app::with_interval(1.0 / 3.0, 0.1, inf, 2), app::kInterval)) ==
          "median [%],median lower [%],median upper [%]\n0.333333333333333,0.1,\n");
    CHECK(app::as_csv(doubted({}, app::kInterval)) ==
          "median [%],median lower [%],median upper [%]\n,,\n");
    CHECK(app::as_csv(doubted(app::with_error(16.24, 0.31, 1), app::kError)) ==
          "median [%],median std error [%]\n16.24,0.31\n");
    CHECK(app::as_csv(doubted(app::range(0.1, 0.9, 0), app::kRange)) ==
          "median lower [%],median upper [%]\n0.1,0.9\n");
    CHECK(app::as_csv(doubted(app::Number{.value = 3.0, .known_to = 2.7},
                              app::kExtrapolated)) == "median [%],median extrapolated\n3,1\n");
    CHECK(app::as_csv(doubted(app::Number{.value = 2.0, .sense = app::Sense::above},
                              app::kCensored)) == "median [%],median censored\n2,1\n");
    CHECK(app::as_csv(doubted(app::Number{}, app::kCensored | app::kExtrapolated)) ==
          "median [%],median extrapolated,median censored\n,,\n");
}

TEST_CASE("table: a text is never read as a number, and no two columns share a name",
          "[app][table]")
{
    const app::Table t = table("", {"n", {"n", app::kInterval}},
                               {{"wall [1, 2]", app::count(3)}, {"a +- b†", app::count(4)}});
    CHECK(app::as_csv(t) == "n (group),n,n lower,n upper\n\"wall [1, 2]\",3,,\na +- b†,4,,\n");
    CHECK(app::shown(t).rows[0][0] == "wall [1, 2]");
}

TEST_CASE("table: sentences stand below the table for people, each once, and in a column of "
          "their own for programs",
          "[app][table]")
{
    const app::Table t =
        table("", {"a", {"note", app::kNote}},
              {{"1", "All walls stood."}, {"2", {}}, {"3", "All walls stood."}});
    CHECK(app::as_text(t) == "a  note\n1   [1]\n2      \n3   [1]\n[1] All walls stood.\n");
    CHECK(app::as_csv(t) == "a,note\n1,All walls stood.\n2,\n3,All walls stood.\n");
    CHECK(app::as_text(table("", {"a", {"note", app::kNote}}, {{"1", {}}})) == "a\n1\n");
}

TEST_CASE("table: a row gets its note in the last column, behind empty cells", "[app][table]")
{
    app::Table t = table("", {"a", "b", "c", {"note", app::kNote}}, {});
    app::add_row(t, app::joined({"1"}, {"2"}), "Why.");
    app::add_row(t, {"3", "4", "5"});
    CHECK(app::as_csv(t) == "a,b,c,note\n1,2,,Why.\n3,4,5,\n");
}

TEST_CASE("table: no line is wider than the terminal; the keys stand in every block",
          "[app][table]")
{
    app::Table t;
    for (int c = 0; c < 12; ++c) t.head.emplace_back("column " + std::to_string(c));
    t.head.emplace_back("note", app::kNote);
    t.rows.emplace_back(12, "0.123456");
    t.rows.back().emplace_back(
        "A sentence that is longer than the terminal of forty columns is wide.");
    const auto all = lines(app::as_text(t, 40));
    int keys = 0;
    for (const std::string& line : all) {
        CHECK(line.size() <= 40);
        keys += line.starts_with("column 0");
    }
    CHECK(keys == 4); // three further columns in each block
}

TEST_CASE("table: columns for programs alone are not shown to people", "[app][table]")
{
    const app::Table t = table("", {"a", {"b", app::kProgramsOnly}}, {{"1", "2"}});
    CHECK(app::as_text(t) == "a\n1\n");
    CHECK(app::as_csv(t) == "a,b\n1,2\n");
}

TEST_CASE("markup: names that would be obeyed are written as they read", "[app][markup]")
{
    CHECK(app::markdown_text("<script>x</script>") == "\\<script>x\\</script>");
    CHECK(app::markdown_text("a\\|b") == "a\\\\\\|b");
    CHECK(app::markdown_text("two\r\nlines\rthree") == "two lines three");
    CHECK(app::markdown_text("[x](http://y)") == "[x]\\(http://y)");
    CHECK(app::markdown_text("median [%]") == "median [%]");
    CHECK(app::latex_text("[1.2, 3]") == "{}[1.2, 3]");
    CHECK(app::latex_text("*a") == "{}*a");
    CHECK(app::latex_text(">= 2") == "$\\geq$ 2");
    CHECK(app::latex_text("1 +- 2") == "1 $\\pm$ 2");
    CHECK(app::latex_text("a\n\nb") == "a  b");
    CHECK(app::csv_cell("a\rb") == "\"a\rb\"");
}

TEST_CASE("markup: a name that a spreadsheet would run as a formula is marked as a text in CSV",
          "[app][table]")
{
    CHECK(app::csv_cell("=cmd|' /C calc'!A0") == "'=cmd|' /C calc'!A0");
    CHECK(app::csv_cell("=HYPERLINK(\"x\")") == "\"'=HYPERLINK(\"\"x\"\")\"");
    for (const char first : std::string("+-@\t")) {
        const std::string name = first + std::string("A1");
        CHECK(app::csv_cell(name) == "'" + name);
    }
    CHECK(app::csv_cell("-") == "-");
    CHECK(app::csv_cell("a=b") == "a=b");
    CHECK(app::as_csv(table("", {"=a"}, {{std::string("@b")}, {app::Number{-1.5}}})) ==
          "'=a\n'@b\n-1.5\n");
}

TEST_CASE("markup: text is broken at blanks and keeps its own lines", "[app][markup]")
{
    CHECK(app::wrapped("one two three", 7) == "one two\nthree");
    CHECK(app::wrapped("one two three", 0) == "one two three");
    CHECK(app::wrapped("one\ntwo\n", 80) == "one\ntwo\n");
    CHECK(app::wrapped("a-word-too-long b", 5) == "a-word-too-long\nb");
    CHECK(app::hung("  a  one two three four\nb\n", 15) ==
          "  a  one two\n     three four\nb\n");
    CHECK(app::hung("one two three four", 9) == "one two\n  three\n  four\n");
    CHECK(app::hung("a-word-too-long b\n", 5) == "a-word-too-long b\n");
}

TEST_CASE("table: a change of units leaves no digits that nobody wrote", "[app][table]")
{
    const app::Table t =
        table("", {"at [mm]", {"peak [kN]", app::kError}},
              {{app::plain_number(5.500000000000001, 2), app::with_error(20.3, 0.004, 1)}});
    CHECK(lines(app::as_csv(t)).at(1) == "5.5,20.3,0.004");
    CHECK(app::cell_text(t.rows[0][1]) == "20.3 +- 0.004"); // not "+- 0.0"
    // inputs are given to the bit
    CHECK(lines(app::as_csv(table("", {"x"}, {{app::Number{0.1 + 0.2}}}))).at(1) ==
          "0.30000000000000004");
}
