#include "app/input/wall/drawn_ends.hpp"

#include "app/drawing/outlines/raw_drawing.hpp"
#include "app/input/study/study.hpp"
#include "app/input/study/units.hpp"
#include "app/text/number_text.hpp"
#include "dem/scene/layout.hpp"
#include "dem/scene/touching.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace app {
namespace {

std::vector<dem::Block> blocks_of(const GeometryInput& geometry)
{
    std::vector<dem::Block> blocks;
    for (const dem::DrawnUnit& unit : geometry.units)
        blocks.push_back(dem::block_of(unit.outline));
    return blocks;
}

double top_of(const std::vector<dem::Block>& blocks)
{
    return std::ranges::max_element(blocks, {}, &dem::Block::z1)->z1;
}

/// Length of the sides that a beam lies on [m].
double level_length(const std::vector<dem::Block>& blocks)
{
    const double top = top_of(blocks);
    double sum = 0.0;
    for (const dem::Block& b : blocks)
        for (const auto& [from, to] : dem::level_sides(b, top, true)) sum += to - from;
    return sum;
}

std::string metres(double length) { return fixed(length, 2) + " m"; }

void note_top(const std::vector<dem::Block>& blocks, std::vector<std::string>& notes)
{
    constexpr double kWhole = 0.999; // of the length; less is told
    const double length = std::ranges::max_element(blocks, {}, &dem::Block::x1)->x1 -
                          std::ranges::min_element(blocks, {}, &dem::Block::x0)->x0;
    const double level = level_length(blocks);
    if (level >= kWhole * length) return;
    notes.push_back("The beam rests on " + metres(level) + " of the wall's " + metres(length) +
                    ": only the level sides at its highest point.");
}

bool stands(const dem::Block& block)
{
    return std::ranges::any_of(dem::level_sides(block, 0.0, false), [](const auto& side) {
        return side.second - side.first >= dem::kShortestFace;
    });
}

/// Blocks that begin within a tenth of a block's height above the floor were meant to stand on
/// it, as far as one can see.
void note_floor(const std::vector<dem::Block>& blocks, std::vector<std::string>& notes)
{
    constexpr double kLowest = 0.1; // of the mean height of a block
    double mean = 0.0, highest = 0.0;
    for (const dem::Block& b : blocks)
        mean += (b.z1 - b.z0) / static_cast<double>(blocks.size());
    std::size_t lowest = 0, standing = 0;
    for (const dem::Block& b : blocks) {
        if (b.z0 > kLowest * mean) continue;
        ++lowest;
        if (stands(b))
            ++standing;
        else
            highest = std::max(highest, b.z0);
    }
    if (standing == lowest) return;
    notes.push_back(std::to_string(standing) + " of " + std::to_string(lowest) +
                    " lowest blocks stand on the floor; the others have no level side there "
                    "and begin up to " +
                    millimetres(highest) + " above it.");
}

} // namespace

void require_level_top(const Masonry& masonry)
{
    if (!masonry.beam.present) return;
    const std::vector<dem::Block> blocks = blocks_of(masonry.geometry);
    if (level_length(blocks) > 0.0) return;
    throw BadValue("no block has a level side at the highest point of the wall, " +
                   metres(top_of(blocks)) +
                   " above the floor, for a beam to lie on; draw one there, or write "
                   "beam.present = no, without the other keys of the beam, load.pattern = body "
                   "and load.vertical_stress = 0 MPa");
}

std::vector<std::string> notes_of_ends(const Masonry& masonry)
{
    const std::vector<dem::Block> blocks = blocks_of(masonry.geometry);
    std::vector<std::string> notes;
    if (masonry.beam.present) note_top(blocks, notes);
    note_floor(blocks, notes);
    return notes;
}

} // namespace app
