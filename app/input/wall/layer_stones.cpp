#include "app/input/wall/layer_stones.hpp"

#include "app/input/study/key_range.hpp"
#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/text/number_text.hpp"
#include "app/text/words.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace app {
namespace {

// The ends of the keys of the wall's own stone.
constexpr double kStiffestStone = 1e9 * kModulus.high; // [Pa]
constexpr double kHeaviest = kDensity.high;            // [kg/m3]

} // namespace

std::pair<std::string, std::string_view> named_part(std::string_view text)
{
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return {"", text};
    return {std::string(trimmed(text.substr(0, colon))), trimmed(text.substr(colon + 1))};
}

void parse_layer_stones(Study& study)
{
    GeometryInput& g = study.geometry;
    if (g.layer_stones.empty()) return;
    for (const std::string_view part : split(g.layer_stones, ";")) {
        const auto [name, values] = named_part(part);
        const std::vector<std::string_view> v = split(values, ",");
        if (name.empty() || v.size() != 3)
            throw BadValue(
                in_quotes(part) +
                " is not a stone of a layer; write for example \"lintel: 30 GPa, 0.2, "
                "2500 kg/m3\"");
        const dem::Elastic stone{parse_quantity(v[0], "GPa"), parse_quantity(v[1], ""),
                                 parse_quantity(v[2], "kg/m3")};
        if (!(stone.young_modulus > 0.0 && stone.poisson_ratio >= 0.0 &&
              stone.poisson_ratio < 0.5 && stone.density >= 0.0 &&
              stone.young_modulus <= kStiffestStone && stone.density <= kHeaviest))
            throw BadValue(in_quotes(part) + ": Young's modulus must be in (0, " +
                           number(kModulus.high, 6) +
                           "] GPa, Poisson's ratio in [0, 0.5), the density in [0, " +
                           number(kHeaviest, 6) + "] kg/m3");
        if (std::ranges::find(g.layers, name) != g.layers.end())
            throw BadValue("the layer " + in_quotes(name) + " has two stones; remove one");
        g.layers.push_back(name);
        g.stones.push_back(stone);
    }
}

std::string layers_text(const Drawing& drawing)
{
    constexpr std::size_t kMost = 12;
    std::set<std::string> names;
    for (const DrawnBlock& b : drawing.blocks)
        if (!b.layer.empty()) names.insert(b.layer);
    if (names.empty()) return "; it has no layers";
    std::string text;
    std::size_t n = 0;
    for (const std::string& name : names)
        if (++n <= kMost) text += (text.empty() ? "; it has: " : ", ") + name;
    return names.size() > kMost ? text + ", ..." : text;
}

std::string layers_note(const Drawing& drawing, const std::vector<std::string>& others)
{
    constexpr std::size_t kMost = 6;
    std::map<std::string, std::size_t> stones;
    for (const DrawnBlock& b : drawing.blocks)
        if (std::ranges::find(others, b.layer) == others.end()) ++stones[b.layer];
    if (stones.size() < 2) return "";
    std::string text;
    std::size_t n = 0;
    for (const auto& [layer, count] : stones)
        if (++n <= kMost)
            text += (text.empty() ? "" : ", ") + counted(count, "stone", "stones") +
                    (layer.empty() ? " without a layer" : " on " + in_quotes(layer));
    if (n > kMost) text += " and more on " + counted(n - kMost, "layer", "layers");
    return "All layers that are shown count as stones: " + text +
           ". Turn a layer off if what it holds is none (mortar, ground).";
}

} // namespace app
