#include "app/push/pier_table.hpp"

#include "app/study/answers/number_cells.hpp"
#include "app/study/pushed/both_ways.hpp"
#include "app/study/pushed/pier_remark.hpp"
#include "app/text/number_text.hpp"
#include "fragility/codes/code_table.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace app {
namespace {

/// A limit state with a drift limit, of a code that the study asks for.
struct CapState {
    std::string code, state; ///< "ntc" "SLC"
};

std::vector<CapState> caps_of(const ReadingRules& rules)
{
    std::vector<CapState> caps;
    for (const fragility::Code& code : rules.sets)
        for (const fragility::CodeState& s : code.states)
            if (!s.drifts.empty()) caps.push_back({code.name, s.name});
    return caps;
}

template <class Take>
void each_push(int direction, std::span<const PushedWall> walls, Take take)
{
    for (const PushedWall& w : walls) {
        take(w, way_name(direction));
        if (const PushedWall* const other = other_way_of(w)) take(*other, way_name(-direction));
    }
}

/// A pier or a spandrel of a push.
template <class Part> struct PartRow {
    const PushedWall* wall;
    const char* way;
    std::size_t place;
    const Part* part;
};
using PierPart = PartRow<PierReading>;
using SpandrelPart = PartRow<SpandrelReading>;

/// One row for each part of each push.
template <class Part>
std::vector<PartRow<Part>> rows_of(int direction, std::span<const PushedWall> walls,
                                   std::vector<Part> PushedWall::*parts)
{
    std::vector<PartRow<Part>> rows;
    each_push(direction, walls, [&](const PushedWall& w, const char* way) {
        for (std::size_t i = 0; i < (w.*parts).size(); ++i)
            rows.push_back({&w, way, i, &(w.*parts)[i]});
    });
    return rows;
}

/// Stress, direction and number stand before every row.
template <class R> TableColumns<R> keys_of(const char* part)
{
    return {{"stress [MPa]", [](const R& r) { return stress_cell(r.wall->vertical_stress); }},
            {"pushed to the", [](const R& r) { return r.way; }},
            {part, [](const R& r) { return count(r.place + 1); }}};
}

/// A number of a part in SI, shown as `scale` times it.
template <class R, class Value>
TableColumn<R> number_of(Head head, int decimals, double scale, Value value)
{
    return {head, [=](const R& r) { return plain_number(scale * value(*r.part), decimals); }};
}

double height_of(const PierReading& p) { return p.pier.at.z1 - p.pier.at.z0; }

} // namespace

Table pier_table(const ReadingRules& rules, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Piers";
    t.caption = std::string(kPierNumbers) +
                " 'Carries little': never 5 % of the wall's force; such a pier governs "
                "nothing. 'So far': it has kept its shear, and its mode may change. Limit: "
                "drift that a code allows this pier; reached: movement of the "
                "load when the pier reaches it, '>' where the push ended before.";
    t.keys = 3;
    using Pier = const PierReading&;
    auto columns = keys_of<PierPart>("pier");
    append(
        columns,
        {{{"storey", kDetail}, [](const PierPart& r) { return count(r.part->pier.storey); }},
         number_of<PierPart>({"from [m]", kDetail}, 2, 1.0,
                             [](Pier p) { return p.pier.at.x0; }),
         number_of<PierPart>({"to [m]", kDetail}, 2, 1.0, [](Pier p) { return p.pier.at.x1; }),
         number_of<PierPart>({"height [m]", kDetail}, 2, 1.0, height_of),
         number_of<PierPart>({"N before [kN]", kDetail}, 1, 1e-3,
                             [](Pier p) { return p.facts.normal_before; }),
         number_of<PierPart>("N [kN]", 1, 1e-3, [](Pier p) { return p.facts.normal_at_peak; }),
         number_of<PierPart>("V [kN]", 1, 1e-3, [](Pier p) { return p.facts.shear_at_peak; }),
         number_of<PierPart>({"largest V [kN]", kDetail}, 1, 1e-3,
                             [](Pier p) { return p.facts.most_shear; }),
         number_of<PierPart>("drift [%]", 3, 100.0, [](Pier p) { return p.drift; }),
         {"mode", [](const PierPart& r) { return std::string(mode_text(*r.part)); }},
         number_of<PierPart>({"H0/D", kDetail}, 2, 1.0,
                             [](Pier p) { return p.facts.slenderness; })});
    for (const CapState& c : caps_of(rules)) {
        const auto cap = [c](Pier p) -> const PierCap& { return *cap_of(p, c.code, c.state); };
        columns.push_back({c.code + " " + c.state + " limit [%]", [cap](const PierPart& r) {
                               const double drift = cap(*r.part).drift;
                               return drift > 0.0 ? Cell(plain_number(100.0 * drift, 2))
                                                  : Cell();
                           }});
        columns.push_back(
            {{c.code + " " + c.state + " reached [mm]", kCensored},
             [cap](const PierPart& r) { return limit_cell(cap(*r.part).wall, 1e3, 2); }});
    }
    fill(t, columns, rows_of(rules.direction, walls, &PushedWall::piers));
    return t;
}

Table pier_limit_table(const ReadingRules& rules, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Limit states of piers";
    t.caption = "Each pier read as a wall of its own: its shear over the movement of its upper "
                "end against its lower end; drifts are over its own height; '>' marks limit "
                "states that it had not reached when the push ended.";
    t.keys = 4;
    const std::vector<StateName> names = state_names(rules);
    struct StateRow : PierPart {
        std::size_t state;
        [[nodiscard]] const fragility::LimitDisplacement& limit() const
        {
            return part->own.limits.at(state);
        }
    };
    std::vector<StateRow> rows;
    for (const PierPart& pier : rows_of(rules.direction, walls, &PushedWall::piers))
        for (std::size_t s = 0; s < names.size(); ++s) rows.push_back({pier, s});
    auto columns = keys_of<StateRow>("pier");
    columns.push_back(
        {"limit state", [&](const StateRow& r) { return state_name(names[r.state]); }});
    append(columns,
           limit_columns<StateRow>([](const StateRow& r) { return r.limit(); },
                                   [](const StateRow& r) { return height_of(*r.part); }));
    columns.push_back(
        {{"note", kNote}, [](const StateRow& r) { return std::string(r.limit().reason); }});
    fill(t, columns, rows);
    return t;
}

Table spandrel_table(const ReadingRules& rules, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Spandrels";
    t.caption = std::string(kSpandrelNumbers);
    t.keys = 3;
    using Spandrel = const SpandrelReading&;
    auto columns = keys_of<SpandrelPart>("spandrel");
    append(
        columns,
        {number_of<SpandrelPart>("from [m]", 2, 1.0,
                                 [](Spandrel s) { return s.spandrel.at.x0; }),
         number_of<SpandrelPart>("to [m]", 2, 1.0, [](Spandrel s) { return s.spandrel.at.x1; }),
         number_of<SpandrelPart>(
             "height [m]", 2, 1.0,
             [](Spandrel s) { return s.spandrel.at.z1 - s.spandrel.at.z0; }),
         number_of<SpandrelPart>("N [kN]", 1, 1e-3,
                                 [](Spandrel s) { return s.facts.normal_at_peak; }),
         number_of<SpandrelPart>("V [kN]", 1, 1e-3,
                                 [](Spandrel s) { return s.facts.shear_at_peak; }),
         number_of<SpandrelPart>("largest V [kN]", 1, 1e-3,
                                 [](Spandrel s) { return s.facts.most_shear; }),
         number_of<SpandrelPart>("drift [%]", 3, 100.0, [](Spandrel s) { return s.drift; })});
    fill(t, columns, rows_of(rules.direction, walls, &PushedWall::spandrels));
    return t;
}

namespace {

std::string piers_remark(const ReadingRules& rules, const PushedWall& w, const char* way)
{
    std::string text;
    const std::vector<CapState> caps = caps_of(rules);
    for (const CapState& c : caps) {
        // A code with several drift limits names each of them.
        const bool alone = std::ranges::count(caps, c.code, &CapState::code) == 1;
        const std::string limit = "the drift limit of " + c.code + (alone ? "" : " " + c.state);
        text += text.empty() ? "pushed to the " + std::string(way) + ", " : "; ";
        const int first = governing_pier(w.piers, c.code, c.state);
        if (first == 0) {
            text += "no pier reaches " + limit;
            continue;
        }
        const PierCap& cap =
            *cap_of(w.piers[static_cast<std::size_t>(first) - 1], c.code, c.state);
        text += "pier " + std::to_string(first) + " is the first to reach " + limit + ", " +
                number(100.0 * cap.drift, 3) + " %, when the load has moved by " +
                fixed(cap.wall.displacement * 1e3, 1) + " mm";
    }
    return text;
}

std::string pier_paragraph(const PushedWall& w, const char* way)
{
    std::string text =
        std::string("Piers from the left, pushed to the ") + way +
        ", with their forces when the wall carries most and their own drift at the "
        "end: ";
    for (std::size_t i = 0; i < w.piers.size(); ++i) {
        const PierReading& p = w.piers[i];
        text += (i == 0 ? "" : "; ") + std::to_string(i + 1) + " (" +
                fixed(p.pier.at.x1 - p.pier.at.x0, 2) + " x " +
                fixed(p.pier.at.z1 - p.pier.at.z0, 2) + " m) N " +
                fixed(p.facts.normal_at_peak * 1e-3, 0) + " kN, V " +
                fixed(p.facts.shear_at_peak * 1e-3, 0) + " kN, " + fixed(100.0 * p.drift, 2) +
                " %, " + std::string(mode_text(p));
    }
    return text + ".";
}

} // namespace

std::vector<std::string> piers_remarks(const ReadingRules& rules, const PushedWall& wall)
{
    std::vector<std::string> all;
    each_push(rules.direction, {&wall, 1}, [&](const PushedWall& w, const char* way) {
        if (!w.piers.empty() && !caps_of(rules).empty())
            all.push_back(piers_remark(rules, w, way));
    });
    return all;
}

std::vector<std::string> pier_paragraphs(const ReadingRules& rules, const PushedWall& wall)
{
    std::vector<std::string> all;
    each_push(rules.direction, {&wall, 1}, [&](const PushedWall& w, const char* way) {
        if (!w.piers.empty()) all.push_back(pier_paragraph(w, way));
    });
    return all;
}

namespace {

/// The limit state whose drift limit governs one: its own, or that of the one it is a share of.
std::string capped_state(const ReadingRules& rules, const StateName& state)
{
    const fragility::Code* const code = fragility::find_code(rules.sets, state.set);
    if (code == nullptr) return {};
    for (const fragility::CodeState& s : code->states)
        if (s.name == state.name && s.drifts.empty() && s.of >= 0)
            return code->states[static_cast<std::size_t>(s.of)].name;
    return state.name;
}

/// A pier and its drift limit.
struct Governing {
    int pier = 0; ///< from 1; 0: none
    const PierCap* cap = nullptr;
};

Governing governing(const ReadingRules& rules, const PushedWall& wall, const StateName& state,
                    std::size_t index)
{
    const std::vector<int>& piers = wall.reading.governing;
    const int pier = index < piers.size() ? piers[index] : 0;
    if (pier == 0) return {};
    return {pier, cap_of(wall.piers[static_cast<std::size_t>(pier) - 1], state.set,
                         capped_state(rules, state))};
}

} // namespace

std::string pier_note(const ReadingRules& rules, const PushedWall& wall, const StateName& state,
                      std::size_t index)
{
    const int first = governing(rules, wall, state, index).pier;
    return first == 0 ? "" : "; pier " + std::to_string(first) + " is the first to reach it";
}

std::string pier_rule(const ReadingRules& rules, const PushedWall& wall, const StateName& state,
                      std::size_t index)
{
    const Governing g = governing(rules, wall, state, index);
    if (g.pier == 0) return {};
    return "pier " + std::to_string(g.pier) + " reaches the drift that " + state.set +
           " allows it, " + number(100.0 * g.cap->drift, 3) + " %";
}

} // namespace app
