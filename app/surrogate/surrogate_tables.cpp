#include "app/output/picture/chart_svg.hpp"
#include "app/output/table/cells.hpp"
#include "app/surrogate/surrogate_output.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::size_t kNamedWalls = 5;

std::string answer_of(const LevelSurrogate& l, bool chaos)
{
    if (l.chaos_is_better != chaos) return "";
    return l.doubts.empty() ? "better" : "better, not to be trusted";
}

std::string joined_sentences(const std::vector<std::string>& sentences)
{
    std::string text;
    for (const std::string& s : sentences) text += (text.empty() ? "" : " ") + s;
    return text;
}

std::string with_unit(const SurrogateStudy& s, const std::string& name)
{
    return name + " [" + std::string(s.response->unit.name) + "]";
}

void add_index_row(const SurrogateStudy& s, const LevelSurrogate& l, std::size_t k,
                   const uq::ChaosIndices& shares, Table& t)
{
    const auto j = static_cast<Eigen::Index>(k);
    Row row = {stress_cell(l.points.stress), s.walls->inputs[s.inputs[k]].key};
    if (l.no_indices.empty())
        row = joined(row, {plain_number(shares.first(j), 3), plain_number(shares.total(j), 3)});
    else
        row = joined(row, Row(2));
    std::string note = l.no_indices;
    if (k < l.given.size()) {
        const GivenData& g = l.given[k];
        const auto cell = [](const std::optional<uq::Estimate>& e) {
            return e ? Cell(with_interval(e->value, e->interval, 2)) : Cell{};
        };
        row = joined(row, {cell(g.rank), cell(g.hsic), plain_number(g.p_value, 3)});
        if (!(g.p_value < kDependsLevel))
            note += std::string(note.empty() ? "" : " ") +
                    "These walls do not show that the response depends on this input.";
    }
    add_row(t, row, note);
}

/// The first of these walls by their names, and how many more there are.
std::string first_named(const SurrogateStudy& s, const std::vector<WallKey>& walls)
{
    const std::string more =
        walls.size() > kNamedWalls
            ? " and " + std::to_string(walls.size() - kNamedWalls) + " more"
            : "";
    return named(*s.walls, walls, kNamedWalls) + more;
}

} // namespace

Table surrogate_table(const SurrogateStudy& s)
{
    Table t;
    t.title =
        "How well the " + words(*s.response) + " of a wall is predicted without running it";
    t.caption = "Q2 is the share of the variance that is explained on walls left out, RMSE the "
                "error there: of the "
                "Gaussian process with parameters fitted anew, of the polynomial chaos with "
                "terms chosen anew, without each tenth of the walls.";
    t.keys = 2;
    t.head = {"stress [MPa]",       "surrogate", "walls",        "Q2",
              with_unit(s, "RMSE"), "answer",    {"note", kNote}};
    for (const LevelSurrogate& l : s.levels) {
        const std::size_t walls = l.points.sample.size();
        const std::string note = joined_sentences(l.doubts);
        const auto row = [&](const char* kind, const SurrogateError& e, bool chaos) {
            add_row(t,
                    {stress_cell(l.points.stress), std::string(kind), count(walls),
                     plain_number(e.q2, 3), plain_number(e.rmse, decimals_for(e.rmse)),
                     answer_of(l, chaos)},
                    chaos == l.chaos_is_better ? note : "");
        };
        if (l.process) row("Gaussian process", l.process_error, false);
        if (l.chaos) row("polynomial chaos", l.chaos_error, true);
        if (!l.chaos && !l.process)
            add_row(t, {stress_cell(l.points.stress), std::string("none"), count(walls)}, note);
    }
    return t;
}

Table surrogate_index_table(const SurrogateStudy& s)
{
    Table t;
    t.title = "What the " + words(*s.response) + " depends on";
    t.caption =
        "Shares of the variance from the coefficients of the polynomial chaos (Sobol'; "
        "of the input alone, and with "
        "its interactions); Cramer-von Mises and HSIC (Da Veiga) from the walls "
        "alone, with 95 % intervals, and the probability of as much dependence by chance.";
    t.keys = 2;
    t.head = {"stress [MPa]",
              "input",
              "Sobol' first",
              "Sobol' total",
              {"Cramer-von Mises", kInterval},
              {"HSIC", kInterval},
              "p of no dependence",
              {"note", kNote}};
    for (const LevelSurrogate& l : s.levels) {
        uq::ChaosIndices shares;
        if (l.chaos) shares = uq::sobol_indices(l.chaos->chaos);
        for (std::size_t k = 0; k < s.inputs.size(); ++k) add_index_row(s, l, k, shares, t);
    }
    return t;
}

Table surrogate_wall_table(const SurrogateStudy& s)
{
    Table t;
    t.title = "Walls and what is predicted of them";
    t.caption = "Predictions of the better surrogate, fitted without the wall.";
    t.keys = 2;
    t.head = {"stress [MPa]", "sample", with_unit(s, words(*s.response)),
              with_unit(s, "predicted")};
    for (const LevelSurrogate& l : s.levels)
        for (Eigen::Index i = 0; i < l.left_out.size(); ++i)
            t.rows.push_back({stress_cell(l.points.stress),
                              count(l.points.sample[static_cast<std::size_t>(i)]),
                              plain_number(l.points.y(i), decimals_for(l.points.y(i))),
                              plain_number(l.left_out(i), decimals_for(l.left_out(i)))});
    return t;
}

Table surrogate_mode_table(const SurrogateStudy& s)
{
    Table t;
    t.title = "How well the failure mode of a wall is told without running it";
    t.caption =
        "Multinomial logit in the coordinates of the inputs, on walls left out (tenth by "
        "tenth): walls whose likeliest mode is theirs, and Brier's skill over the "
        "shares of the modes (1: no error, 0: as good as the shares).";
    t.head = {"stress [MPa]", "walls", "modes", "right [%]", "skill", {"note", kNote}};
    for (std::size_t i = 0; i < s.modes.size(); ++i) {
        const ModeSurrogate& m = s.modes[i];
        std::string modes;
        for (const int mode : m.modes)
            modes += (modes.empty() ? "" : ", ") + std::string(mode_name(mode));
        Row row = {stress_cell(s.levels[i].points.stress), count(m.walls), modes};
        if (m.none.empty())
            row = joined(row, {plain_number(100.0 * m.right, 0), plain_number(m.skill, 2)});
        add_row(t, row, m.none + joined_sentences(m.doubts));
    }
    return t;
}

std::string surrogate_picture(const SurrogateStudy& s, const LevelSurrogate& l)
{
    const std::string what =
        words(*s.response) + " [" + std::string(s.response->unit.name) + "]";
    Chart c;
    c.title = "Predicted without the wall, " + stress_text(l.points.stress);
    c.x_label = what;
    c.y_label = "predicted " + what;
    c.width = c.height = 420.0;
    const double low = std::min(l.points.y.minCoeff(), l.left_out.minCoeff());
    const double high = std::max(l.points.y.maxCoeff(), l.left_out.maxCoeff());
    c.series.push_back({.name = "equal",
                        .x = {low, high},
                        .y = {low, high},
                        .line = LineStyle::dashed,
                        .width = 1.0});
    c.series.push_back({.name = "walls",
                        .x = {l.points.y.begin(), l.points.y.end()},
                        .y = {l.left_out.begin(), l.left_out.end()},
                        .line = LineStyle::none,
                        .points = true});
    return line_chart(c);
}

std::string left_out_text(const SurrogateStudy& s, const LevelSurrogate& l)
{
    std::string text;
    const std::string at = stress_text(l.points.stress) + ": ";
    if (!l.points.without.empty())
        text += at + counted(l.points.without.size(), "wall has", "walls have") + " no " +
                words(*s.response) + " and " + (l.points.without.size() == 1 ? "is" : "are") +
                " left out: " + first_named(s, l.points.without) + "\n";
    if (!l.points.bounds.empty())
        text += at + counted(l.points.bounds.size(), "wall outlasts", "walls outlast") +
                " the push, so that only a bound of the " + words(*s.response) +
                " is known, and " + (l.points.bounds.size() == 1 ? "is" : "are") +
                " left out: " + first_named(s, l.points.bounds) + ". " +
                (predicts(l) ? "What is learned holds for the others; push" : "Push") +
                " further to keep them.\n";
    if (l.points.failed > 0)
        text += at + counted(l.points.failed, "wall", "walls") + " failed and " +
                (l.points.failed == 1 ? "is" : "are") + " left out.\n";
    if (l.points.beyond > 0)
        text += at + "learned from the first " + std::to_string(l.points.sample.size()) +
                " walls; " + std::to_string(l.points.beyond) + " more are in the file.\n";
    return text;
}

bool predicts(const SurrogateStudy& s)
{
    return std::ranges::any_of(s.levels, [](const LevelSurrogate& l) { return predicts(l); }) ||
           std::ranges::any_of(s.modes, [](const ModeSurrogate& m) { return m.none.empty(); });
}

std::string surrogate_remarks(const SurrogateStudy& s)
{
    std::string text;
    for (const LevelSurrogate& l : s.levels) {
        for (const std::string& doubt : l.doubts)
            text += stress_text(l.points.stress) + ": not to be trusted. " + doubt + "\n";
        if (l.doubts.empty() && !l.no_indices.empty())
            text +=
                stress_text(l.points.stress) + ": no indices of Sobol'. " + l.no_indices + "\n";
        text += left_out_text(s, l);
    }
    return text;
}

} // namespace app
