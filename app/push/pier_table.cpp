#include "app/push/pier_table.hpp"

#include "app/input/limit_state_text.hpp"
#include "app/study/both_ways.hpp"
#include "app/study/fragility_text.hpp"
#include "app/text/number_text.hpp"
#include "fragility/code_table.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace app {
namespace {

/// A limit state with a drift limit, of a code that the study asks for.
struct CapState {
    std::string code, state; ///< "ntc" "SLC"
};

std::vector<CapState> caps_of(const Study& study)
{
    std::vector<CapState> caps;
    for (const fragility::Code& code : reading_rules(study).sets)
        for (const fragility::CodeState& s : code.states)
            if (!s.drifts.empty()) caps.push_back({code.name, s.name});
    return caps;
}

/// Stress, direction and number stand before every row.
template <class Rows>
void each_wall(const Study& study, std::span<const PushedWall> walls, Rows rows)
{
    const int direction = push_way(study).direction;
    for (const PushedWall& w : walls) {
        rows(w, way_name(direction));
        if (const PushedWall* const other = other_way_of(w)) rows(*other, way_name(-direction));
    }
}

} // namespace

Table pier_table(const Study& study, const std::vector<PushedWall>& walls)
{
    const std::vector<CapState> caps = caps_of(study);
    Table t;
    t.title = "Piers";
    t.caption =
        "N: compression, V: shear, in a cut through all piers of a storey, when the wall "
        "carries most. Drift: of the upper end of a pier against its lower end, over its own "
        "height, at the end of the push. H0/D: moment over shear and length, when the pier "
        "carries most. 'Carries little': never 5 % of the wall's force; such a pier governs "
        "nothing. Limit: drift that a code allows this pier; reached: movement of the "
        "load when the pier reaches it, '>' where the push ended before.";
    t.keys = 3;
    t.head = {"stress [MPa]",
              "pushed to the",
              "pier",
              {"storey", kDetail},
              {"from [m]", kDetail},
              {"to [m]", kDetail},
              {"height [m]", kDetail},
              {"N before [kN]", kDetail},
              "N [kN]",
              "V [kN]",
              {"largest V [kN]", kDetail},
              "drift [%]",
              "mode",
              {"H0/D", kDetail}};
    for (const CapState& c : caps) {
        t.head.emplace_back(c.code + " " + c.state + " limit [%]");
        t.head.emplace_back(c.code + " " + c.state + " reached [mm]", kCensored);
    }
    each_wall(study, walls, [&](const PushedWall& w, const char* way) {
        for (std::size_t i = 0; i < w.piers.size(); ++i) {
            const PierReading& p = w.piers[i];
            Row row = {stress_cell(w.vertical_stress),
                       std::string(way),
                       count(static_cast<int>(i) + 1),
                       count(p.pier.storey),
                       plain_number(p.pier.at.x0, 2),
                       plain_number(p.pier.at.x1, 2),
                       plain_number(p.pier.at.z1 - p.pier.at.z0, 2),
                       plain_number(p.facts.normal_before * 1e-3, 1),
                       plain_number(p.facts.normal_at_peak * 1e-3, 1),
                       plain_number(p.facts.shear_at_peak * 1e-3, 1),
                       plain_number(p.facts.most_shear * 1e-3, 1),
                       plain_number(100.0 * p.drift, 3),
                       std::string(mode_text(p)),
                       plain_number(p.facts.slenderness, 2)};
            for (const CapState& c : caps) {
                const PierCap& cap = *cap_of(p, c.code, c.state);
                row.emplace_back(cap.drift > 0.0 ? plain_number(100.0 * cap.drift, 2) : Cell());
                row.emplace_back(limit_cell(cap.wall, 1e3, 2));
            }
            t.rows.push_back(std::move(row));
        }
    });
    return t;
}

Table pier_limit_table(const Study& study, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Limit states of piers";
    t.caption = "Each pier read as a wall of its own: its shear over the movement of its upper "
                "end against its lower end; drifts are over its own height; '>' marks limit "
                "states that it had not reached when the push ended.";
    t.keys = 4;
    t.head = {"stress [MPa]",
              "pushed to the",
              "pier",
              "limit state",
              {"displacement [mm]", kCensored},
              {"drift [%]", kCensored},
              {"note", kNote}};
    const std::vector<StateName> names = state_names(reading_rules(study));
    each_wall(study, walls, [&](const PushedWall& w, const char* way) {
        for (std::size_t i = 0; i < w.piers.size(); ++i)
            for (std::size_t s = 0; s < names.size(); ++s) {
                const PierReading& p = w.piers[i];
                const fragility::LimitDisplacement& limit = p.own.limits.at(s);
                add_row(t,
                        {stress_cell(w.vertical_stress), std::string(way),
                         count(static_cast<int>(i) + 1), state_name(names[s]),
                         limit_cell(limit, 1e3, 2),
                         limit_cell(limit, 100.0 / (p.pier.at.z1 - p.pier.at.z0), 3)},
                        std::string(limit.reason));
            }
    });
    return t;
}

Table spandrel_table(const Study& study, const std::vector<PushedWall>& walls)
{
    Table t;
    t.title = "Spandrels";
    t.caption =
        "Masonry and lintel above each opening, cut in the middle of the opening, when the "
        "wall carries most: N, compression along the wall; V, by how much its right half "
        "presses its left half down.";
    t.keys = 3;
    t.head = {"stress [MPa]", "pushed to the", "spandrel", "from [m]",      "to [m]",
              "height [m]",   "N [kN]",        "V [kN]",   "largest V [kN]"};
    each_wall(study, walls, [&](const PushedWall& w, const char* way) {
        for (std::size_t i = 0; i < w.spandrels.size(); ++i) {
            const SpandrelReading& s = w.spandrels[i];
            t.rows.push_back({stress_cell(w.vertical_stress), std::string(way),
                              count(static_cast<int>(i) + 1), plain_number(s.spandrel.at.x0, 2),
                              plain_number(s.spandrel.at.x1, 2),
                              plain_number(s.spandrel.at.z1 - s.spandrel.at.z0, 2),
                              plain_number(s.normal_at_peak * 1e-3, 1),
                              plain_number(s.shear_at_peak * 1e-3, 1),
                              plain_number(s.most_shear * 1e-3, 1)});
        }
    });
    return t;
}

namespace {

std::string piers_remark(const Study& study, const PushedWall& w, const char* way)
{
    std::string text;
    const std::vector<CapState> caps = caps_of(study);
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

std::vector<std::string> piers_remarks(const Study& study, const PushedWall& wall)
{
    std::vector<std::string> all;
    each_wall(study, {&wall, 1}, [&](const PushedWall& w, const char* way) {
        if (!w.piers.empty() && !caps_of(study).empty())
            all.push_back(piers_remark(study, w, way));
    });
    return all;
}

std::vector<std::string> pier_paragraphs(const Study& study, const PushedWall& wall)
{
    std::vector<std::string> all;
    const int direction = push_way(study).direction;
    if (!wall.piers.empty()) all.push_back(pier_paragraph(wall, way_name(direction)));
    const PushedWall* const other = other_way_of(wall);
    if (other != nullptr && !other->piers.empty())
        all.push_back(pier_paragraph(*other, way_name(-direction)));
    return all;
}

namespace {

/// The limit state whose drift limit governs one: its own, or that of the one it is a share of.
std::string capped_state(const Study& study, const StateName& state)
{
    const ReadingRules rules = reading_rules(study);
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

Governing governing(const Study& study, const PushedWall& wall, const StateName& state,
                    std::size_t index)
{
    const std::vector<int>& piers = wall.reading.governing;
    const int pier = index < piers.size() ? piers[index] : 0;
    if (pier == 0) return {};
    return {pier, cap_of(wall.piers[static_cast<std::size_t>(pier) - 1], state.set,
                         capped_state(study, state))};
}

} // namespace

std::string pier_note(const Study& study, const PushedWall& wall, const StateName& state,
                      std::size_t index)
{
    const int first = governing(study, wall, state, index).pier;
    return first == 0 ? "" : "; pier " + std::to_string(first) + " is the first to reach it";
}

std::string pier_rule(const Study& study, const PushedWall& wall, const StateName& state,
                      std::size_t index)
{
    const Governing g = governing(study, wall, state, index);
    if (g.pier == 0) return {};
    return "pier " + std::to_string(g.pier) + " reaches the drift that " + state.set +
           " allows it, " + number(100.0 * g.cap->drift, 3) + " %";
}

} // namespace app
