#include "dem/block/model.hpp"

#include <cmath>
#include <stdexcept>

namespace dem {

namespace {

bool is_bed(const Face& f) { return f.from.z == f.to.z; }

struct Stiffness {
    double kn, ks;
};

Stiffness reference_of(const Face& f, const ReferenceStiffness& r)
{
    if (f.kind == FaceKind::unit_crack) return {r.crack.kn, r.crack.ks};
    return {r.joint.kn, r.joint.ks};
}

/// Contact points along a face. They are as dense as on the face of a half unit.
FacePoints points_of(const Face& f, const WallGeometry& wall, const Discretisation& d)
{
    const double length = std::hypot(f.to.x - f.from.x, f.to.z - f.from.z);
    const double interval = 0.5 * wall.unit_length / (d.contact_points - 1);
    const int intervals = std::max(1, static_cast<int>(std::lround(length / interval)));
    return face_points(d.face_rule, intervals + 1, d.zones_per_interval);
}

Motion motion_of(const WallGeometry& wall, const Layout& layout, LoadPattern pattern, int block)
{
    const Block& b = layout.blocks[block];
    if (block == layout.beam)
        return pattern == LoadPattern::beam ? Motion::driven : Motion::free;
    if (b.course != 1) return Motion::free;
    const bool toe = wall.toe == Toe::held && b.x1 == wall.length;
    if (wall.base == Base::fixed)
        return toe ? Motion::clamped_bottom_held_right : Motion::clamped_bottom;
    return toe ? Motion::held_right_corner : Motion::free;
}

/// Everything that a block's element depends on, as numbers. Blocks with equal keys share one element.
std::vector<double> key_of(const BlockSpec& s)
{
    const auto micron = [](double x) { return std::round(x * 1e6); };
    std::vector<double> key{micron(s.width), micron(s.height), static_cast<double>(s.motion)};
    for (const BlockEdge& e : s.edges)
        for (const double x :
             {micron(e.from.x), micron(e.from.z), micron(e.to.x), micron(e.to.z), e.kn, e.ks,
              static_cast<double>(e.points.position.size())})
            key.push_back(x);
    return key;
}

/// Faces of each block, in the order of the layout.
std::vector<std::vector<int>> faces_by_block(const Layout& layout)
{
    std::vector<std::vector<int>> faces(layout.blocks.size());
    for (std::size_t f = 0; f < layout.faces.size(); ++f)
        for (const int block : {layout.faces[f].a, layout.faces[f].b})
            if (block != kGround) faces[block].push_back(static_cast<int>(f));
    return faces;
}

/// @param faces of the block, indices in Layout::faces
BlockSpec spec_of(int block, const std::vector<int>& faces, const Model& m,
                  const ReferenceStiffness& reference, const Discretisation& d)
{
    const Block& b = m.layout.blocks[block];
    const bool is_beam = block == m.layout.beam;
    BlockSpec s;
    s.width = b.x1 - b.x0;
    s.height = b.z1 - b.z0;
    s.thickness = m.wall.thickness;
    s.material = is_beam ? m.beam.material : m.stone;
    s.motion = motion_of(m.wall, m.layout, m.loads.pattern, block);
    s.load_height = m.loads.height - b.z0;
    s.rotation_fixed = is_beam && m.beam.rotation == BeamRotation::fixed;
    s.face_rule = d.face_rule;
    s.zones_per_interval = d.zones_per_interval;
    s.zone_size = 0.5 * m.wall.unit_length / ((d.contact_points - 1) * d.zones_per_interval);
    s.modes = is_beam ? d.beam_modes : d.block_modes;
    for (const int face : faces) {
        const Face& f = m.layout.faces[face];
        const auto [kn, ks] = reference_of(f, reference);
        s.edges.push_back({{f.from.x - b.x0, f.from.z - b.z0},
                           {f.to.x - b.x0, f.to.z - b.z0},
                           points_of(f, m.wall, d),
                           kn,
                           ks});
    }
    return s;
}

void place_blocks(const ReferenceStiffness& reference, const Discretisation& d, Model& m)
{
    const std::vector<std::vector<int>> faces = faces_by_block(m.layout);
    std::vector<std::vector<double>> keys;
    for (int block = 0; block < static_cast<int>(m.layout.blocks.size()); ++block) {
        const BlockSpec spec = spec_of(block, faces[block], m, reference, d);
        const std::vector<double> key = key_of(spec);
        const auto known = std::find(keys.begin(), keys.end(), key);
        const int element = static_cast<int>(known - keys.begin());
        if (known == keys.end()) {
            keys.push_back(key);
            m.elements.push_back(block_element(spec));
        }
        m.places.push_back({element, m.n_points, m.n_modes});
        m.n_points += static_cast<int>(m.elements[element].points.size());
        m.n_modes += static_cast<int>(m.elements[element].phi.cols());
    }
    m.ground_point = m.n_points;
}

int point_of(const Model& m, int block, Point at)
{
    if (block == kGround) return m.ground_point;
    const Block& b = m.layout.blocks[block];
    const BlockPlace& place = m.places[block];
    return place.first_point +
           find_point(m.elements[place.element], {at.x - b.x0, at.z - b.z0});
}

std::vector<Contact>& list_of(const Face& f, Model& m)
{
    if (f.kind == FaceKind::unit_crack) return m.cracks;
    const bool tied = f.kind == FaceKind::beam_joint && m.beam.interface == BeamInterface::tied;
    return tied ? m.tied : m.dry;
}

int material_of(const Face& f)
{
    if (f.kind == FaceKind::base_joint) return kBaseMaterial;
    if (f.kind == FaceKind::beam_joint) return kBeamMaterial;
    return f.id - 1;
}

void connect(const Discretisation& d, Model& m)
{
    for (std::size_t i = 0; i < m.layout.faces.size(); ++i) {
        const Face& f = m.layout.faces[i];
        const FacePoints points = points_of(f, m.wall, d);
        const double dx = f.to.x - f.from.x, dz = f.to.z - f.from.z,
                     length = std::hypot(dx, dz);
        for (std::size_t k = 0; k < points.position.size(); ++k) {
            const Point at{f.from.x + points.position[k] * dx,
                           f.from.z + points.position[k] * dz};
            list_of(f, m).push_back({point_of(m, f.a, at), point_of(m, f.b, at),
                                     is_bed(f) ? 0.0 : 1.0, is_bed(f) ? 1.0 : 0.0,
                                     points.weight[k] * length * m.wall.thickness,
                                     material_of(f), static_cast<int>(i)});
        }
    }
}

void check(const WallGeometry& wall, const Elastic& stone, const Beam& beam, const Loads& loads,
           const ReferenceStiffness& reference, const Discretisation& d)
{
    const auto require = [](bool ok, const char* what) {
        if (!ok) throw std::invalid_argument(what);
    };
    const double top = wall.courses * wall.course_height;
    require(wall.courses >= 1 && wall.length > 0 && wall.thickness > 0 &&
                wall.course_height > 0 && wall.unit_length > 0,
            "a wall needs positive sizes and at least one course");
    require(wall.bond_offset >= 0 && wall.bond_offset < 1,
            "bond offset must be in [0, 1) unit lengths");
    require(beam.height > 0 || !beam.present, "beam height must be positive");
    const bool driven = loads.pattern == LoadPattern::beam;
    require(beam.present || !driven, "without a beam a wall is pushed by body forces only");
    require(beam.present || loads.vertical_stress == 0.0,
            "without a beam there is nothing for the vertical stress to act on");
    require(driven || beam.rotation == BeamRotation::free,
            "body forces move the beam with the wall: its rotation cannot be fixed");
    const bool heavy = stone.density > 0 || (beam.present && beam.material.density > 0);
    require(driven || (heavy && loads.gravity > 0),
            "body forces are in proportion to weight: density and gravity must be positive");
    for (const Elastic& m : {stone, beam.present ? beam.material : stone})
        require(m.young_modulus > 0 && m.poisson_ratio >= 0 && m.poisson_ratio < 0.5 &&
                    m.density >= 0,
                "elastic: E > 0, Poisson's ratio in [0, 0.5), density >= 0");
    require(loads.vertical_stress >= 0 && loads.gravity >= 0,
            "vertical stress and gravity must not be negative");
    require(!driven || (loads.height >= top - 1e-9 && loads.height <= top + beam.height + 1e-9),
            "the load line must lie within the beam");
    require(reference.joint.kn > 0 && reference.joint.ks > 0,
            "the reference stiffness of the joints must be positive");
    require(!wall.cracks_in_units || (reference.crack.kn > 0 && reference.crack.ks > 0),
            "the reference stiffness of the cracks must be positive");
    require(d.contact_points >= 2 && d.zones_per_interval >= 1,
            "at least 2 contact points and 1 zone");
    for (const int modes : {d.block_modes, d.beam_modes})
        require(modes == 0 || modes >= 3, "modes: 0 (all) or at least 3 (rigid)");
}

} // namespace

Model discretise(const WallGeometry& wall, const Elastic& stone, const Beam& beam,
                 const Loads& loads, const ReferenceStiffness& reference,
                 const Discretisation& d)
{
    check(wall, stone, beam, loads, reference, d);
    Model m;
    m.wall = wall;
    m.beam = beam;
    m.loads = loads;
    m.stone = stone;
    m.reference = reference;
    m.layout = lay_out(wall, beam.present ? beam.height : 0.0);
    place_blocks(reference, d, m);
    connect(d, m);
    return m;
}

} // namespace dem
