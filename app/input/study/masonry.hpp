#pragma once
/// The wall of a study: its sizes, what is not built by sizes alone (drawings, rubble,
/// openings), where its units crack, the beam on it, and the materials of all.

#include "app/input/study/parameters.hpp"
#include "dem/scene/drawn_layout.hpp"
#include "dem/scene/paper_materials.hpp"
#include "dem/scene/wall.hpp"

#include <string>
#include <vector>

namespace app {

/// A wall that is drawn, or of rubble, in place of courses.
struct GeometryInput {
    bool rubble = false;              ///< random stones fill the wall
    int layouts = 1;                  ///< random ones, which the samples take in turn
    int material = 0;                 ///< index in kMaterialNames; 0: none
    std::string file;                 ///< drawing or picture; empty: none
    std::string outlines;             ///< in place of a file, as outlines_text() writes them
    double length_unit = 1e-3;        ///< of the drawing [m]
    double snap = 5e-4;               ///< gaps and overlaps that are closed [m], >= 0
    bool close_outlines = false;      ///< open outlines of four corners or more
    double picture_width = 0.0;       ///< [m]; 0: not given
    double picture_height = 0.0;      ///< [m]; 0: not given
    double simplify = 5e-3;           ///< tolerance of outlines traced from a picture [m], >= 0
    std::string openings;             ///< in courses: "x, z, width, height; ..."
    std::string layer_stones;         ///< "NAME: E, Poisson's ratio, density; ..."
    std::vector<std::string> layers;  ///< whose stone is not the wall's
    std::vector<dem::Elastic> stones; ///< of these layers
    std::vector<dem::DrawnUnit> units; ///< what was read, or the stones of rubble once grown
    std::vector<std::string>
        drawn_layers;               ///< all of a drawing; the layers of units count from 1
    std::vector<std::string> notes; ///< what was closed, simplified or ignored on the way
};

/// Where units may crack, as text (unit_cracks.hpp).
struct CrackInput {
    bool in_units = true;
    std::string pattern;      ///< "grid(4, 4)"; empty: mid, or none where not in_units
    std::string where;        ///< "toe", or "x, z, width, height"; empty: everywhere
    std::string elsewhere;    ///< a pattern; empty: mid
    bool cut_nothing = false; ///< a drawn wall has no unit that the patterns cut
};

/// All that stands there, and of what.
struct Masonry {
    dem::WallGeometry wall;
    GeometryInput geometry;
    CrackInput cracks;
    dem::Beam beam{.material = {.poisson_ratio = 0.2}}; // choice: concrete
    Parameters parameters;
    std::vector<ParameterRule> rules; ///< for parameters that were not given and follow others
};

} // namespace app
